// Text in and out: whole files, lines, words, and numbers that survive the round trip bit for bit.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace frit::io {

// The bytes of a file. InputError if it is missing, a folder, or may not be read; MachineError if the disk
// fails.
std::string read_file_whole(const std::filesystem::path& path);

// Appends the shortest digits that read back to the same bits ("nan", "inf" for what is not finite).
void append_number(std::string& text, double value);
void append_number(std::string& text, std::int64_t value);

// The number that the whole of `word` spells (a leading '+', "nan" and "inf" are allowed), or nothing.
std::optional<double> parse_real(std::string_view word);
std::optional<std::int64_t> parse_whole(std::string_view word);

// Why `word` is not a finite number or not a whole one, for a fault's text: "'abc' is not a number".
std::string explain_real(std::string_view word);
std::string explain_whole(std::string_view word);

// The word in quotes, cut to a readable length, without control characters.
std::string show(std::string_view word);

// Without blanks, tabs and line ends at both ends.
std::string_view trim(std::string_view text);
std::string to_lower(std::string_view text);

// Replaces `words` by the parts of `line` between blanks.
void split_at_blanks(std::string_view line, std::vector<std::string_view>& words);

// Goes through the lines of a text that must outlive it; skips a UTF-8 byte order mark.
class LineReader {
 public:
  explicit LineReader(std::string_view text);

  // Goes to the next line; false at the end, where line() is empty and number() the last line's.
  bool next();
  std::string_view line() const { return line_; }  // without its line end
  std::size_t number() const { return number_; }   // from 1
  std::size_t bytes_left() const { return text_.size() - position_; }
  bool only_blanks_left() const;

 private:
  std::string_view text_, line_;
  std::size_t position_ = 0, number_ = 0;
};

}  // namespace frit::io
