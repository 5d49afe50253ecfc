#include <gtest/gtest.h>

#include <random>

#include "config/toml_screen.hpp"
#include "samples.hpp"

namespace frit::config {
namespace {

std::string many(std::size_t count, const std::string& text) {
  std::string result;
  for (std::size_t n = 0; n < count; ++n) result += text;
  return result;
}

TEST(HostileText, IsRefusedWithLineAndReason) {
  const std::pair<std::string, std::string> samples[] = {
      {"a = 1\nb = \"\xFF\"\n", "case.toml:2: not TOML: this line is not valid UTF-8"},
      {"# \xC0\xAF\n", "case.toml:1: not TOML: this line is not valid UTF-8"},
      {"# \xED\xA0\x80\n", "not valid UTF-8"},
      {"# \xF4\x90\x80\x80\n", "not valid UTF-8"},
      {"# \xE2\x82", "not valid UTF-8"},
      {std::string("a = 1\n\0", 7), "case.toml:2: not TOML: control character 0x00"},
      {"a = \"\x1B[1m\"\n", "control character 0x1B"},
      {"größe = 1\n", "beyond ASCII outside quotation marks"},
      {"a = 1 \xE2\x80\x83\n", "beyond ASCII"},
      {"a = \"open\nb = 1\n", "case.toml:1: not TOML: a string is not closed"},
      {"a = '''open\n\n\n", "case.toml:1: not TOML: a string is not closed"},
      {"[=]\n", "a table header without a name"},
      {"[[=]]\n", "a table header without a name"},
      {"[", "a table header without a name"},
      {"a = " + many(33, "["), "nested too deeply; allowed are 32 levels"},
      {"a = " + many(100000, "{a="), "nested too deeply"},
      {many(100000, "a.") + "a = 1", "nested too deeply"},
      {"a = 1\na = 2\n", "case.toml:2: "},
      {"a = \n", "case.toml:1: "},
      {"a = 99999999999999999999\n", "case.toml:1: "},
      {"[a\n", "case.toml:1: "},
      {"a = _\n", "case.toml:1: "},
  };
  for (const auto& [text, part] : samples) {
    const auto faults = faults_of(text);
    ASSERT_EQ(faults.size(), 1U) << text.substr(0, 60) << "\n" << all_of(faults);
    EXPECT_NE(faults[0].find(part), std::string::npos) << text.substr(0, 60) << "\n" << faults[0];
  }
}

TEST(HostileText, LargerThanTheLimitIsRefused) {
  const auto faults = faults_of(std::string(largest_text + 1, '#'));
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_NE(faults[0].find("allowed are 67108864"), std::string::npos) << faults[0];
}

TEST(HostileText, ScreenLetsOrdinaryTomlPass) {
  for (const std::string text : {"a = \"[[[[ # \\\" µ\" # ü ]]]\n", "a = '\\'\nb = 1\n",
                                 "a = \"\"\"x\"\"y\\\"\"\"\"\"\nb = '''it''s'''\n",
                                 "[\"quoted\".'name']\r\nx = [\r\n  [1.5, 2.5], # c\r\n  [3.5]\r\n]\n",
                                 "\n[ a ]\n[[ b ]]\n", "a = \"\"\nb = ''\n"})
    EXPECT_NO_THROW(screen_toml(text)) << text;
  EXPECT_NO_THROW(parse_case("\xEF\xBB\xBF" + least_case, "case.toml"));
  std::string lines = least_case;
  for (auto at = lines.find('\n'); at != lines.npos; at = lines.find('\n', at + 2))
    lines.replace(at, 1, "\r\n");
  EXPECT_NO_THROW(parse_case(lines, "case.toml"));
}

// A sample with every kind of token, to be cut and damaged.
const std::string rich = "title = \"a \\u00E9 µ\" # c\n" + least_case +
                         "[temperature]\nprogram = [{ rate = 1e-1, to = 1000 }, { hold = '1 h' }]\n"
                         "[[particles]]\nids = [0, 0x1F, 1_000]\nforce = [0.0, -1, +2.5e-3]\nfixed = true\n"
                         "[cell]\nkind = \"\"\"periodic\"\"\"\nother = 1979-05-27T07:32:00Z\n";

TEST(HostileText, TruncatedAnywhereIsReadOrRefused) {
  for (std::size_t length = 0; length <= rich.size(); ++length)
    EXPECT_NO_FATAL_FAILURE(faults_of(rich.substr(0, length)));
}

TEST(HostileText, DamagedAnywhereIsReadOrRefused) {
  std::mt19937 random(11);
  const std::string tokens = "[]{}=.,\"'#\n\r\t \\_-+0123456789eExobTZ:inftrueanul\xC3\xA9\x80\xFF\x00";
  for (int n = 0; n < 10000; ++n) {
    std::string text = rich;
    for (auto edits = 1 + random() % 6; edits > 0; --edits) {
      const auto at = random() % text.size();
      const char token = tokens[random() % tokens.size()];
      switch (random() % 3) {
        case 0:
          text[at] = token;
          break;
        case 1:
          text.insert(at, 1 + random() % 3, token);
          break;
        default:
          text.erase(at, 1 + random() % 5);
      }
      if (text.empty()) text.push_back(token);
    }
    EXPECT_NO_FATAL_FAILURE(faults_of(text));
  }
}

TEST(HostileText, RandomTokensAreReadOrRefused) {
  std::mt19937 random(12);
  const std::string tokens[] = {"[",     "]",          "[[",     "]]",  "{", "}",       "=",    ".",    ",",
                                "\"",    "'",          "\"\"\"", "'''", "#", "\n",      " ",    "a",    "_",
                                "-",     "1",          "0x",     "1e",  "+", "inf",     "nan",  "true", "\\",
                                "\\u12", "1979-05-27", "T07:32", ":",   "Z", "packing", "stop", "é"};
  for (int n = 0; n < 10000; ++n) {
    std::string text;
    for (auto length = random() % 24; length > 0; --length) text += tokens[random() % std::size(tokens)];
    EXPECT_NO_FATAL_FAILURE(faults_of(text));
    EXPECT_NO_FATAL_FAILURE(faults_of("", {"stop.time=" + text, text}));
  }
}

}  // namespace
}  // namespace frit::config
