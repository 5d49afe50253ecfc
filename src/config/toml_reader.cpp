#include "config/toml_reader.hpp"

#include <toml++/toml.h>

#include <algorithm>
#include <string>

#include "config/toml_screen.hpp"

namespace frit::config {
namespace {

Place place_of(const toml::source_region& region) { return {.line = static_cast<int>(region.begin.line)}; }

Table convert_table(const toml::table& table);

Node convert(const toml::node& node) {
  Node result;
  result.place = place_of(node.source());
  if (const auto* table = node.as_table()) {
    result.value = convert_table(*table);
  } else if (const auto* array = node.as_array()) {
    List list;
    list.items.reserve(array->size());
    for (const auto& item : *array) list.items.push_back(convert(item));
    result.value = std::move(list);
  } else if (const auto* text = node.as_string()) {
    result.value = text->get();
  } else if (const auto* integer = node.as_integer()) {
    result.value = integer->get();
  } else if (const auto* number = node.as_floating_point()) {
    result.value = number->get();
  } else if (const auto* boolean = node.as_boolean()) {
    result.value = boolean->get();
  } else {
    result.value = DateOrTime{};
  }
  return result;
}

Table convert_table(const toml::table& table) {
  Table result;
  result.entries.reserve(table.size());
  for (const auto& [key, node] : table)
    result.entries.push_back({std::string(key.str()), place_of(key.source()), convert(node)});
  // The library sorts by name; faults and defaults read better in the order of the file.
  std::stable_sort(result.entries.begin(), result.entries.end(),
                   [](const Entry& a, const Entry& b) { return a.place.line < b.place.line; });
  return result;
}

void move_to(Node& node, Place place) {
  node.place = place;
  if (auto* list = node.as<List>())
    for (auto& item : list->items) move_to(item, place);
  if (auto* table = node.as<Table>())
    for (auto& entry : table->entries) {
      entry.place = place;
      move_to(entry.node, place);
    }
}

// The library's words without its lead, and what usually is behind them.
std::string fault_text(std::string_view said) {
  const auto lead = said.find(": ");
  if (said.starts_with("Error while parsing") && lead != said.npos) said.remove_prefix(lead + 2);
  std::string text(said);
  if (said.starts_with("could not determine value type"))
    text = "this is no value; a text stands in quotation marks, e.g. \"copper\"";
  if (said.starts_with("cannot redefine")) text += "; allowed: once";
  if (said.ends_with("saw ','")) text += "; a number has a decimal point";
  return text;
}

}  // namespace

Table read_toml(std::string_view text) {
  if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
  screen_toml(text);
  try {
    return convert_table(toml::parse(text));
  } catch (const toml::parse_error& error) {
    throw TextFault(static_cast<int>(error.source().begin.line), fault_text(error.description()));
  }
}

Node read_toml_value(std::string_view text, Place place) {
  const auto begin = text.find_first_not_of(" \t");
  const bool bracketed =
      begin != std::string_view::npos && std::string_view("\"'[{").find(text[begin]) != text.npos;
  try {
    auto table = read_toml("value = " + std::string(text));
    if (table.entries.size() == 1 && text.find('\n') == text.npos) {
      Node node = std::move(table.entries.front().node);
      move_to(node, place);
      return node;
    }
  } catch (const TextFault&) {
    if (bracketed) throw;
  }
  return {std::string(text), place};
}

}  // namespace frit::config
