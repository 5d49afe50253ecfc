#include "io/text.hpp"

#include <cmath>
#include <limits>
#include <random>

#include "temporary_folder.hpp"

namespace frit::io {
namespace {

std::string written(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

TEST(Text, RandomBitsSurviveTheRoundTrip) {
  std::mt19937_64 generator(7);
  for (int trial = 0; trial < 100000; ++trial) {
    const std::uint64_t bits = generator();
    double value = 0.0;
    std::memcpy(&value, &bits, sizeof value);
    if (!std::isfinite(value)) continue;
    const auto read = parse_real(written(value));
    ASSERT_TRUE(read.has_value()) << written(value);
    ASSERT_EQ(std::memcmp(&*read, &value, sizeof value), 0) << written(value);
  }
}

TEST(Text, NumbersAreShort) {
  EXPECT_EQ(written(0.1), "0.1");
  EXPECT_EQ(written(5e-6), "5e-06");
  EXPECT_EQ(written(-0.0), "-0");
  EXPECT_EQ(written(2.0), "2");
}

TEST(Text, OnlyWholeWordsAreNumbers) {
  EXPECT_EQ(parse_real("+1.5e-3"), 1.5e-3);
  for (const auto word : {"", "1.5x", " 1", "1 ", "--1", "+-1", "0x10", "1,5", "1e999"}) {
    EXPECT_FALSE(parse_real(word).has_value()) << word;
  }
  EXPECT_EQ(parse_whole("-12"), -12);
  for (const auto word : {"", "1.0", "1e3", "9223372036854775808"})
    EXPECT_FALSE(parse_whole(word).has_value()) << word;
}

TEST(Text, ExplanationsSayWhatIsWrong) {
  EXPECT_EQ(explain_real("abc"), "'abc' is not a number");
  EXPECT_EQ(explain_real("1,5"), "'1,5' is not a number (decimals need a point)");
  EXPECT_EQ(explain_real("nan"), "'nan' is not finite");
  EXPECT_EQ(explain_real("1e999"), "'1e999' is beyond the range of a double");
  EXPECT_EQ(explain_real(""), "the cell is empty, a number is needed");
  EXPECT_EQ(explain_whole("1.5"), "'1.5' is not a whole number");
  EXPECT_EQ(explain_whole("99999999999999999999"), "'99999999999999999999' is beyond 64 bits");
}

TEST(Text, FaultsNeverShowLongOrUnprintableWords) {
  EXPECT_EQ(show(std::string(50, 'a')), "'" + std::string(40, 'a') + "...'");
  EXPECT_EQ(show("a\x1b\n"),
            "'a?"
            "?'");
}

TEST(Text, LinesAreCountedWhateverTheirEnds) {
  LineReader lines(
      "\xef\xbb\xbf"
      "a\r\n\nb");
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "a");
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "");
  EXPECT_FALSE(lines.only_blanks_left());
  ASSERT_TRUE(lines.next());
  EXPECT_EQ(lines.line(), "b");
  EXPECT_EQ(lines.number(), 3u);
  EXPECT_TRUE(lines.only_blanks_left());
  EXPECT_FALSE(lines.next());
}

TEST(Text, WholeFilesAreReadByteForByte) {
  const TemporaryFolder folder;
  std::string bytes(300000, 'x');
  for (std::size_t k = 0; k < bytes.size(); ++k) bytes[k] = static_cast<char>(k * 31);
  EXPECT_EQ(read_file_whole(folder.write("a", bytes)), bytes);
  EXPECT_EQ(read_file_whole(folder.write("b", "")), "");
  EXPECT_FALSE(read_file_whole("/proc/self/status").empty()) << "a file that does not tell its size";
}

TEST(Text, MissingFilesAndFoldersAreInputFaults) {
  const TemporaryFolder folder;
  const auto missing = folder / "none.csv";
  EXPECT_EQ(faults_of(missing, [&] { read_file_whole(missing); }),
            std::vector<std::string>{"none.csv: cannot be read: No such file or directory"});
  std::filesystem::create_directory(folder / "sub");
  EXPECT_EQ(faults_of(folder / "sub", [&] { read_file_whole(folder / "sub"); }),
            std::vector<std::string>{"sub: cannot be read: it is a folder, a file is needed"});
}

}  // namespace
}  // namespace frit::io
