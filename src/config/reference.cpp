#include "config/reference.hpp"

#include <vector>

#include <fmt/core.h>

#include "config/nearest.hpp"
#include "config/schema.hpp"
#include "core/error.hpp"

namespace frit::config {
namespace {

// "5 um" stays in quotation marks, 0.01, true and lists do not need them.
std::string default_text(const Key& key) {
  if (key.fallback.empty()) return "none";
  const bool has_unit = key.fallback.find(' ') != key.fallback.npos && !key.fallback.starts_with('[');
  const bool word = key.type == Type::choice || key.fallback == "auto";
  return has_unit || word ? fmt::format("\"{}\"", key.fallback) : std::string(key.fallback);
}

std::string describe_key(const Key& key) {
  std::string text = fmt::format("{}\n  {}\n", key.path, key.sentence);
  text += fmt::format("  type: {}\n", type_text(key));
  if (const auto allowed = allowed_text(key); !allowed.empty())
    text += fmt::format("  allowed: {}\n", allowed);
  text += fmt::format("  default: {}\n", default_text(key));
  if (const auto condition = applies_text(key.applies); !condition.empty())
    text += fmt::format("  applies: {}\n", condition);
  if (key.status == Status::not_available_yet) text += "  status: not available yet\n";
  return text;
}

std::string list_keys() {
  std::string text = "Keys of a case file; frit describe KEY or SECTION tells more.\n\n";
  for (const Key& key : schema())
    text += fmt::format("{:<43} {}{}\n", key.path, default_text(key),
                        key.status == Status::not_available_yet ? " (not available yet)" : "");
  return text;
}

std::string section_of(const Key& key) {
  const auto dot = key.path.find('.');
  const bool list = key.type == Type::table_list || key.type == Type::table;
  return dot == key.path.npos && !list ? "" : std::string(key.path.substr(0, dot));
}

std::string in_cell(const std::string& text) {
  std::string escaped;
  for (const char c : text) escaped += fmt::format("{}{}", c == '|' ? "\\" : "", c);
  return escaped;
}

std::string markdown_row(const Key& key) {
  const auto allowed = allowed_text(key);
  const auto condition = applies_text(key.applies);
  std::string meaning(key.sentence);
  if (!condition.empty()) meaning += " Applies " + condition + ".";
  if (key.status == Status::not_available_yet) meaning += " **Not available yet.**";
  return fmt::format("| `{}` | {} | {} | {} | {} |\n", key.path, in_cell(type_text(key)), in_cell(allowed),
                     key.fallback.empty() ? "" : fmt::format("`{}`", default_text(key)), in_cell(meaning));
}

}  // namespace

std::string describe(std::string_view path) {
  if (path.empty()) return list_keys();
  const std::string prefix = std::string(path) + ".";
  std::string text;
  for (const Key& key : schema())
    if (key.path == path || key.path.starts_with(prefix))
      text += fmt::format("{}{}", text.empty() ? "" : "\n", describe_key(key));
  if (!text.empty()) return text;
  std::string names;
  std::vector<std::string> candidates = all_paths();
  for (const auto& section : names_in("")) candidates.push_back(section);
  for (const auto& name : nearest(path, candidates, 3)) names += (names.empty() ? "" : ", ") + name;
  throw InputError(fmt::format("\"{}\" is no key of a case; {}", path.substr(0, 200),
                               names.empty() ? "frit describe lists all keys" : "nearest: " + names));
}

std::string reference_markdown() {
  std::string text =
      "# Keys of a case file\n\n"
      "Generated from the schema (`src/config/schema_table.cpp`); to write it anew, run\n"
      "`FRIT_UPDATE=1 config_test --gtest_filter='Reference.*'`.\n\n"
      "A case file is TOML. A quantity is a string with a unit (`\"5 um\"`, `\"10 K/min\"`) or a bare number "
      "in SI "
      "units.\nUnknown keys, wrong types and units, and values out of range are faults; all are told at "
      "once. "
      "Relative paths\nare relative to the case file's folder.\n";
  std::string section = "none yet";
  for (const Key& key : schema()) {
    if (section != section_of(key)) {
      section = section_of(key);
      text +=
          fmt::format("\n## {}\n\n", section.empty() ? "Top of the file" : fmt::format("`[{}]`", section));
      text += "| key | type | allowed | default | meaning |\n|---|---|---|---|---|\n";
    }
    text += markdown_row(key);
  }
  return text;
}

}  // namespace frit::config
