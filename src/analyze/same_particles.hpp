// Which particle is which between moments from different files.
#pragma once

#include <string>
#include <vector>

#include "analyze/moment.hpp"

namespace frit::analyze {

// What is wrong with comparing `other` with `first`: ids that only one of them has. Empty: they have the
// same.
std::vector<std::string> differences_of_ids(const Moment& first, const Moment& other);

// Leaves the particles that all moments have, with their contacts. InputError where that is none.
void keep_common_particles(std::vector<Moment>& moments);

// Ids become 0, 1, 2, ... in the order they had: files may number particles by anything. All moments must
// have the same ids.
void renumber(std::vector<Moment>& moments);

// Puts each particle of a periodic reference at its periodic copy nearest to where it stands in `start`,
// scaled to the reference's cell.
void unwrap(const State& start, State& reference);

}  // namespace frit::analyze
