#include "config/reference.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <set>
#include <sstream>

#include "config/schema.hpp"
#include "core/error.hpp"

namespace frit::config {
namespace {

// FRIT_UPDATE=1 writes the file anew instead of comparing.
TEST(Reference, CommittedPageIsInStepWithTheSchema) {
  const std::string path = FRIT_SOURCE_FOLDER "/docs/config.md";
  if (std::getenv("FRIT_UPDATE")) std::ofstream(path, std::ios::binary) << reference_markdown();
  std::ostringstream committed;
  committed << std::ifstream(path, std::ios::binary).rdbuf();
  EXPECT_EQ(committed.str(), reference_markdown()) << "run config_test with FRIT_UPDATE=1 to write it anew";
}

TEST(Reference, DescribesEveryKeyOnThePageAndAlone) {
  const auto page = reference_markdown();
  const auto list = describe("");
  for (const Key& key : schema()) {
    const std::string path(key.path);
    EXPECT_NE(page.find("| `" + path + "` |"), page.npos) << path;
    EXPECT_NE(list.find("\n" + path + " "), list.npos) << path;
    EXPECT_TRUE(describe(path).starts_with(path + "\n")) << path;
    EXPECT_NE(describe(path).find(key.sentence), std::string::npos) << path;
  }
}

TEST(Reference, DescribesTypeRangeDefaultAndStatus) {
  const auto eta = describe("contact.sliding_resistance");
  EXPECT_NE(eta.find("type: a number\n"), eta.npos) << eta;
  EXPECT_NE(eta.find("allowed: at least 0, below 0.5\n"), eta.npos);
  EXPECT_NE(eta.find("default: 0.01\n"), eta.npos);
  const auto start = describe("temperature.start");
  EXPECT_NE(start.find("default: \"1050 degC\""), start.npos) << start;
  const auto packing = describe("packing.generate");
  EXPECT_NE(packing.find("\"deposit\" (not available yet)"), packing.npos) << packing;
  const auto wall = describe("wall");
  EXPECT_NE(wall.find("status: not available yet"), wall.npos) << wall;
  const auto size = describe("cell.size");
  EXPECT_NE(size.find("applies: only with cell.kind = \"periodic\" and packing.file"), size.npos) << size;
}

TEST(Reference, DescribesASectionWhole) {
  const auto stop = describe("stop");
  EXPECT_NE(stop.find("stop.time\n"), stop.npos);
  EXPECT_NE(stop.find("stop.relative_density\n"), stop.npos);
  EXPECT_EQ(stop.find("output."), stop.npos);
}

TEST(Reference, NamesTheNearestOfAnUnknownKey) {
  try {
    describe("contact.slidng_resistance");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("nearest: contact.sliding_resistance"), std::string::npos)
        << error.what();
  }
  EXPECT_THROW(describe("?"), InputError);
}

TEST(Schema, IsSoundInItself) {
  std::set<std::string_view> paths;
  for (const Key& key : schema()) {
    EXPECT_TRUE(paths.insert(key.path).second) << "twice: " << key.path;
    EXPECT_TRUE(key.sentence.ends_with('.')) << key.path;
    EXPECT_EQ(key.type == Type::choice || key.type == Type::choice_list, !key.choices.empty()) << key.path;
    EXPECT_EQ(std::holds_alternative<ChoiceListAccess>(key.slot), key.type == Type::choice_list) << key.path;
    EXPECT_EQ(std::holds_alternative<ChoiceAccess>(key.slot), key.type == Type::choice) << key.path;
    EXPECT_EQ(find_key(key.path), &key);
    const bool empty = std::holds_alternative<std::monostate>(key.slot);
    EXPECT_TRUE(!empty || key.status == Status::not_available_yet) << key.path;
  }
  EXPECT_FALSE(find_key("no.such"));
}

}  // namespace
}  // namespace frit::config
