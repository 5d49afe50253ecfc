#include "io/text.hpp"

#include <fcntl.h>
#include <fmt/core.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <cstring>
#include <system_error>

#include "core/error.hpp"
#include "io/write_file.hpp"

namespace frit::io {

namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";
constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

template <class Value>
void append_digits(std::string& text, Value value) {
  std::array<char, 32> digits;
  const auto end = std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr;
  text.append(digits.data(), end);
}

// from_chars knows no leading plus; "+-1" must stay wrong.
std::string_view without_plus(std::string_view word) {
  const bool plus = word.size() > 1 && word[0] == '+' && word[1] != '-' && word[1] != '+';
  return plus ? word.substr(1) : word;
}

template <class Value>
std::errc parse(std::string_view word, Value& value) {
  word = without_plus(word);
  const auto end = word.data() + word.size();
  const auto result = std::from_chars(word.data(), end, value);
  if (result.ec == std::errc() && result.ptr != end) return std::errc::invalid_argument;
  return result.ec;
}

}  // namespace

std::string read_file_whole(const std::filesystem::path& path) {
  const FileDescriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  if (!file.is_open()) {
    throw InputError(fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)));
  }
  struct stat status {};
  if (::fstat(file.get(), &status) == 0 && S_ISDIR(status.st_mode)) {
    throw InputError(fmt::format("{}: cannot be read: it is a folder, a file is needed", path.string()));
  }
  std::string bytes;
  std::size_t filled = 0;
  while (true) {
    constexpr std::size_t least_room = 1 << 16;
    const auto expected = static_cast<std::size_t>(std::max<off_t>(status.st_size, 0)) + 1;
    if (bytes.size() - filled == 0) bytes.resize(std::max({expected, filled + least_room, 2 * filled}));
    const auto count = ::read(file.get(), bytes.data() + filled, bytes.size() - filled);
    if (count < 0 && errno == EINTR) continue;
    if (count < 0) throw_machine_error(path, "reading the file", errno);
    if (count == 0) break;
    filled += static_cast<std::size_t>(count);
  }
  bytes.resize(filled);
  return bytes;
}

void append_number(std::string& text, double value) { append_digits(text, value); }
void append_number(std::string& text, std::int64_t value) { append_digits(text, value); }

std::optional<double> parse_real(std::string_view word) {
  double value = 0.0;
  if (parse(word, value) != std::errc()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parse_whole(std::string_view word) {
  std::int64_t value = 0;
  if (parse(word, value) != std::errc()) return std::nullopt;
  return value;
}

std::string explain_real(std::string_view word) {
  if (word.empty()) return "the cell is empty, a number is needed";
  double value = 0.0;
  const auto error = parse(word, value);
  if (error == std::errc()) return show(word) + " is not finite";
  if (error == std::errc::result_out_of_range) return show(word) + " is beyond the range of a double";
  if (word.find(',') != word.npos) return show(word) + " is not a number (decimals need a point)";
  return show(word) + " is not a number";
}

std::string explain_whole(std::string_view word) {
  if (word.empty()) return "the cell is empty, a whole number is needed";
  std::int64_t value = 0;
  if (parse(word, value) == std::errc::result_out_of_range) return show(word) + " is beyond 64 bits";
  return show(word) + " is not a whole number";
}

std::string show(std::string_view word) {
  constexpr std::size_t longest = 40;
  std::string text(word.substr(0, longest));
  std::ranges::replace_if(
      text, [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == 0x7f; }, '?');
  return "'" + text + (word.size() > longest ? "...'" : "'");
}

std::string_view trim(std::string_view text) {
  const auto begin = text.find_first_not_of(blanks);
  if (begin == text.npos) return {};
  return text.substr(begin, text.find_last_not_of(blanks) - begin + 1);
}

std::string to_lower(std::string_view text) {
  std::string lower(text);
  for (char& c : lower) {
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  }
  return lower;
}

void split_at_blanks(std::string_view line, std::vector<std::string_view>& words) {
  words.clear();
  auto begin = line.find_first_not_of(blanks);
  while (begin != line.npos) {
    const auto end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
}

LineReader::LineReader(std::string_view text) : text_(text) {
  if (text_.starts_with(byte_order_mark)) text_.remove_prefix(byte_order_mark.size());
}

bool LineReader::next() {
  line_ = {};
  if (position_ >= text_.size()) return false;
  const auto end = std::min(text_.find('\n', position_), text_.size());
  line_ = text_.substr(position_, end - position_);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  position_ = std::min(end + 1, text_.size());
  ++number_;
  return true;
}

bool LineReader::only_blanks_left() const { return text_.find_first_not_of(blanks, position_) == text_.npos; }

}  // namespace frit::io
