#include <gtest/gtest.h>

#include "config/toml_reader.hpp"
#include "config/toml_screen.hpp"

namespace frit::config {
namespace {

const Node& at(const Table& table, std::string_view key) {
  const Entry* entry = table.find(key);
  if (!entry) throw std::out_of_range(std::string(key));
  return entry->node;
}

TEST(Document, HoldsEveryKindOfTomlValue) {
  const Table table = read_toml(
      "text = \"a\\tb\"\nraw = 'a\\tb'\nwhole = -3\nhex = 0xFF\nnumber = 1e-3\nyes = true\n"
      "date = 1979-05-27\nlist = [1, \"x\", [2]]\ninner = { a.b = 1 }\n");
  EXPECT_EQ(*at(table, "text").as<std::string>(), "a\tb");
  EXPECT_EQ(*at(table, "raw").as<std::string>(), "a\\tb");
  EXPECT_EQ(*at(table, "whole").as<std::int64_t>(), -3);
  EXPECT_EQ(*at(table, "hex").as<std::int64_t>(), 255);
  EXPECT_EQ(*at(table, "number").as<double>(), 1e-3);
  EXPECT_EQ(*at(table, "yes").as<bool>(), true);
  EXPECT_TRUE(at(table, "date").as<DateOrTime>());
  EXPECT_EQ(at(table, "list").as<List>()->items.size(), 3U);
  const Node& a = at(*at(table, "inner").as<Table>(), "a");
  EXPECT_EQ(*at(*a.as<Table>(), "b").as<std::int64_t>(), 1);
}

TEST(Document, KeepsTheOrderAndTheLinesOfTheFile) {
  const Table table = read_toml("# comment\nzeta = 1\n\nalpha = [\n  1,\n  2,\n]\n[middle]\nx = 1\n");
  ASSERT_EQ(table.entries.size(), 3U);
  EXPECT_EQ(table.entries[0].key, "zeta");
  EXPECT_EQ(table.entries[0].place.line, 2);
  EXPECT_EQ(table.entries[1].key, "alpha");
  EXPECT_EQ(table.entries[1].place.line, 4);
  EXPECT_EQ(table.entries[1].node.as<List>()->items[1].place.line, 6);
  EXPECT_EQ(table.entries[2].place.line, 8);
  EXPECT_EQ(at(*table.entries[2].node.as<Table>(), "x").place.line, 9);
}

TEST(Document, ListsOfTablesKeepEachItemsLine) {
  const Table table = read_toml("[[group]]\na = 1\n[[group]]\na = 2\n");
  const auto& items = at(table, "group").as<List>()->items;
  ASSERT_EQ(items.size(), 2U);
  EXPECT_EQ(items[0].place.line, 1);
  EXPECT_EQ(items[1].place.line, 3);
}

TEST(Document, CountsLinesOfWindowsFilesTheSame) {
  EXPECT_EQ(at(read_toml("a = 1\r\n\r\nb = 2\r\n"), "b").place.line, 3);
}

TEST(Document, FaultsOfTheTextNameTheirLine) {
  try {
    read_toml("a = 1\nb = 2\nc == 3\n");
    FAIL();
  } catch (const TextFault& fault) {
    EXPECT_EQ(fault.line(), 3);
    EXPECT_NE(std::string(fault.what()), "");
  }
}

TEST(OverrideValue, IsTomlWhereItIsTomlAndElseAString) {
  const Place place{.line = 0, .override_index = 4};
  EXPECT_EQ(*read_toml_value("12", place).as<std::int64_t>(), 12);
  EXPECT_EQ(*read_toml_value("1e3", place).as<double>(), 1e3);
  EXPECT_EQ(*read_toml_value("false", place).as<bool>(), false);
  EXPECT_EQ(*read_toml_value("\"12\"", place).as<std::string>(), "12");
  EXPECT_EQ(*read_toml_value("2 h", place).as<std::string>(), "2 h");
  EXPECT_EQ(*read_toml_value("random-dense", place).as<std::string>(), "random-dense");
  EXPECT_EQ(*read_toml_value("", place).as<std::string>(), "");
  EXPECT_EQ(*read_toml_value("1\nb = 2", place).as<std::string>(), "1\nb = 2");
  EXPECT_THROW(read_toml_value("[1, 2", place), TextFault);
  EXPECT_THROW(read_toml_value("{ a = }", place), TextFault);
}

TEST(OverrideValue, StandsAtTheOverrideThroughout) {
  const Place place{.line = 0, .override_index = 4};
  const Node node = read_toml_value("[{ a = 1 }]", place);
  const Node& item = node.as<List>()->items.at(0);
  EXPECT_EQ(item.place.override_index, 4);
  EXPECT_EQ(item.as<Table>()->entries.at(0).place.override_index, 4);
  EXPECT_EQ(at(*item.as<Table>(), "a").place.override_index, 4);
}

}  // namespace
}  // namespace frit::config
