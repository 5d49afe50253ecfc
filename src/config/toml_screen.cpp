#include "config/toml_screen.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace frit::config {
namespace {

bool is_letter_or_digit(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
}

// Bytes of the UTF-8 sequence at the start of `text`, 0 where it is malformed (RFC 3629: no overlong forms,
// no surrogates, nothing above U+10FFFF).
std::size_t utf8_length(std::string_view text) {
  const auto byte = [&](std::size_t n) { return n < text.size() ? static_cast<unsigned char>(text[n]) : 0U; };
  const auto follows = [&](std::size_t n) { return (byte(n) & 0xC0U) == 0x80U; };
  const unsigned first = byte(0);
  if (first < 0x80) return 1;
  if (first >= 0xC2 && first <= 0xDF) return follows(1) ? 2 : 0;
  if (first >= 0xE0 && first <= 0xEF) {
    const bool overlong = first == 0xE0 && byte(1) < 0xA0;
    const bool surrogate = first == 0xED && byte(1) > 0x9F;
    return follows(1) && follows(2) && !overlong && !surrogate ? 3 : 0;
  }
  if (first >= 0xF0 && first <= 0xF4) {
    const bool overlong = first == 0xF0 && byte(1) < 0x90;
    const bool beyond = first == 0xF4 && byte(1) > 0x8F;
    return follows(1) && follows(2) && follows(3) && !overlong && !beyond ? 4 : 0;
  }
  return 0;
}

class Screen {
 public:
  explicit Screen(std::string_view text) : text_(text) {}

  void run() {
    while (at_ < text_.size()) {
      const char c = text_[at_];
      if (c == '#') {
        skip_comment();
      } else if (c == '"' || c == '\'') {
        skip_string(c);
      } else {
        look_at(c);
      }
    }
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw TextFault(line_, what); }

  // One character of any kind, checked as such.
  void advance() {
    const auto length = utf8_length(text_.substr(at_));
    const auto c = static_cast<unsigned char>(text_[at_]);
    if (length == 0) refuse("this line is not valid UTF-8; save the file as UTF-8 text");
    if ((c < 0x20 && c != '\t' && c != '\n' && c != '\r') || c == 0x7F)
      refuse(fmt::format("control character 0x{:02X}; is this a text file?", c));
    if (c == '\n') ++line_;
    at_ += length;
  }

  void skip_comment() {
    while (at_ < text_.size() && text_[at_] != '\n') advance();
  }

  void skip_string(char quote) {
    const int start = line_;
    const std::string fence(3, quote);
    const bool many_lines = text_.substr(at_).starts_with(fence);
    at_ += many_lines ? 3 : 1;
    while (at_ < text_.size() && (many_lines || text_[at_] != '\n')) {
      if (many_lines ? text_.substr(at_).starts_with(fence) : text_[at_] == quote) {
        at_ += many_lines ? 3 : 1;
        // Up to two more quotes belong to the content of a string of several lines.
        for (int n = 0; many_lines && n < 2 && at_ < text_.size() && text_[at_] == quote; ++n) ++at_;
        blank_ = false;
        return;
      }
      if (quote == '"' && text_[at_] == '\\') advance();
      if (at_ < text_.size() && (many_lines || text_[at_] != '\n')) advance();
    }
    throw TextFault(start, "a string is not closed; a quotation mark is missing");
  }

  // A character outside strings and comments.
  void look_at(char c) {
    if (static_cast<unsigned char>(c) >= 0x80)
      refuse(
          "a character beyond ASCII outside quotation marks; put keys and values that hold one into quotes");
    if (c == '[' && blank_ && depth_ == 0) check_header();
    if (c == '[' || c == '{') ++depth_;
    if (c == ']' || c == '}') depth_ = std::max(0, depth_ - 1);
    if (c == '.') ++dots_;
    if (c == '\n' || c == ',' || c == '{' || c == '=') dots_ = 0;
    if (depth_ > deepest_nesting || dots_ > deepest_nesting)
      refuse(fmt::format("nested too deeply; allowed are {} levels", deepest_nesting));
    if (c == '\n') {
      blank_ = true;
    } else if (c != ' ' && c != '\t' && c != '\r') {
      blank_ = false;
    }
    advance();
  }

  // The library assumes that a name follows the bracket.
  void check_header() const {
    auto rest = text_.substr(at_ + 1);
    if (rest.starts_with('[')) rest.remove_prefix(1);
    const auto name = rest.find_first_not_of(" \t");
    const char c = name == rest.npos ? '\n' : rest[name];
    if (!is_letter_or_digit(c) && c != '_' && c != '-' && c != '"' && c != '\'')
      refuse("a table header without a name; write [name] or [[name]]");
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int line_ = 1;
  int depth_ = 0, dots_ = 0;
  bool blank_ = true;  // nothing but blanks on this line so far
};

}  // namespace

void screen_toml(std::string_view text) {
  if (text.size() > largest_text)
    throw TextFault(1, fmt::format("the file has {} bytes; allowed are {}", text.size(), largest_text));
  Screen(text).run();
}

}  // namespace frit::config
