// Looks through TOML text before the library sees it: its 3.3.0 is undefined on some malformed input.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace frit::config {

// The text is not what it should be, at a line (from 1).
class TextFault : public std::runtime_error {
 public:
  TextFault(int line, const std::string& what) : std::runtime_error(what), line_(line) {}
  int line() const { return line_; }

 private:
  int line_;
};

inline constexpr std::size_t largest_text = std::size_t{64} << 20;  // [bytes]
inline constexpr int deepest_nesting = 32;                          // brackets, or dots in one key

// Throws TextFault for text that is too large, not UTF-8, holds control characters, leaves a string open,
// nests too deeply, has characters beyond ASCII outside strings and comments, or a table header without a
// name.
void screen_toml(std::string_view text);

}  // namespace frit::config
