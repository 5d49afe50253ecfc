#include "config/faults.hpp"

#include <gtest/gtest.h>

#include "core/error.hpp"

namespace frit::config {
namespace {

std::vector<std::string> told(Faults& faults) {
  try {
    faults.throw_if_any();
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

TEST(Faults, AreSilentWhereThereAreNone) {
  Faults faults("f.toml", {});
  EXPECT_NO_THROW(faults.throw_if_any());
  EXPECT_FALSE(faults.has("a.b"));
}

TEST(Faults, NameFileLineAndKey) {
  Faults faults("f.toml", {});
  faults.add({.line = 3}, "a.b", "is wrong");
  EXPECT_TRUE(faults.has("a.b"));
  EXPECT_EQ(told(faults), std::vector<std::string>{"f.toml:3: a.b: is wrong"});
}

TEST(Faults, ComeInTheOrderOfTheFileThenOfTheOverrides) {
  Faults faults("f.toml", {"x=1", "y=2"});
  faults.add({.line = 0, .override_index = 1}, "y", "second override");
  faults.add({.line = 9}, "c", "late");
  faults.add({.line = 0, .override_index = 0}, "x", "first override");
  faults.add({.line = 2}, "b", "early");
  faults.add({.line = 2}, "b", "early too");
  faults.add_missing("a", "missing");
  faults.add({.line = 1}, "", "text");
  const std::vector<std::string> expected{
      "f.toml: a: missing",           "f.toml:1: text",    "f.toml:2: b: early",
      "f.toml:2: b: early too",       "f.toml:9: c: late", "--set x=1: x: first override",
      "--set y=2: y: second override"};
  EXPECT_EQ(told(faults), expected);
}

}  // namespace
}  // namespace frit::config
