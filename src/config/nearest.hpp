// The word a user probably meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace frit::config {

// Fewest insertions, deletions, replacements and swaps of neighbours that turn `a` into `b`.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidates nearest to `word`, nearest first (ties in the given order), at most `most` of them; none
// that differ by more than about half of their letters.
std::vector<std::string> nearest(std::string_view word, const std::vector<std::string>& candidates,
                                 std::size_t most);

// "; did you mean X?", or nothing where nothing is near.
std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace frit::config
