#include "analyze/result.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>

#include "config/toml_reader.hpp"
#include "config/toml_screen.hpp"
#include "core/error.hpp"
#include "io/text.hpp"
#include "observe/statistics.hpp"

namespace frit::analyze {
namespace {

namespace fs = std::filesystem;

std::string text_of(const config::Node& node);

std::string list_text(const config::List& list) {
  std::string text;
  for (const config::Node& item : list.items) text += (text.empty() ? "" : ", ") + text_of(item);
  return "[" + text + "]";
}

std::string table_text(const config::Table& table) {
  std::string text;
  for (const config::Entry& entry : table.entries)
    text += (text.empty() ? "" : ", ") + entry.key + " = " + text_of(entry.node);
  return "{" + text + "}";
}

std::string text_of(const config::Node& node) {
  if (const auto* text = node.as<std::string>()) return *text;
  if (const auto* truth = node.as<bool>()) return *truth ? "true" : "false";
  if (const auto* list = node.as<config::List>()) return list_text(*list);
  if (const auto* table = node.as<config::Table>()) return table_text(*table);
  std::string number;
  if (const auto* whole = node.as<std::int64_t>()) io::append_number(number, *whole);
  if (const auto* real = node.as<double>()) io::append_number(number, *real);
  return number;
}

void collect_keys(const config::Table& table, const std::string& prefix,
                  std::map<std::string, std::string>& keys) {
  for (const config::Entry& entry : table.entries) {
    if (const auto* section = entry.node.as<config::Table>()) {
      collect_keys(*section, prefix + entry.key + ".", keys);
    } else {
      keys[prefix + entry.key] = text_of(entry.node);
    }
  }
}

std::map<std::string, std::string> read_keys(const fs::path& path) {
  std::map<std::string, std::string> keys;
  try {
    collect_keys(config::read_toml(io::read_file_whole(path)), "", keys);
  } catch (const config::TextFault& fault) {
    throw InputError(fmt::format("{}: not the case of a result: {}", path.string(), fault.what()));
  }
  return keys;
}

// Older results, and runs that were killed, have no scales.
double read_scale(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return observe::no_value;
  const auto summary = nlohmann::json::parse(io::read_file_whole(path), nullptr, false);
  const auto number = [&](const char* key) {
    const bool known = summary.is_object() && summary.contains(key) && summary[key].is_number();
    return known ? summary[key].get<double>() : observe::no_value;
  };
  return number("surface_energy_J_per_m2") / std::pow(number("mean_radius_m"), 4);
}

}  // namespace

const std::vector<double>* Result::column(const std::string& wanted) const {
  const auto found = std::ranges::find(series.columns, wanted);
  return found == series.columns.end() ? nullptr : &series.values[found - series.columns.begin()];
}

Result read_result(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputError(fmt::format("{}: no such folder; allowed: the folder of a result", folder.string()));
  if (!fs::is_regular_file(folder / "series.csv", error))
    throw InputError(
        fmt::format("{}: holds no series.csv; allowed: the folder of a result", folder.string()));
  Result result{folder.string(), io::read_series(folder / "series.csv"), read_keys(folder / "case.toml"),
                read_scale(folder / "summary.json")};
  if (result.series.values.empty() || result.series.values.front().empty())
    throw InputError((folder / "series.csv").string() + ": has no rows");
  return result;
}

std::vector<CaseDifference> case_differences(const std::vector<Result>& results) {
  std::set<std::string> keys;
  for (const Result& result : results)
    for (const auto& [key, value] : result.keys) keys.insert(key);
  std::vector<CaseDifference> differences;
  for (const std::string& key : keys) {
    CaseDifference difference{key, {}};
    for (const Result& result : results) {
      const auto found = result.keys.find(key);
      difference.values.push_back(found == result.keys.end() ? "" : found->second);
    }
    const auto is_other = [&](const std::string& value) { return value != difference.values.front(); };
    if (std::ranges::any_of(difference.values, is_other)) differences.push_back(std::move(difference));
  }
  return differences;
}

}  // namespace frit::analyze
