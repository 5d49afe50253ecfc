#include "config/case_writer.hpp"

#include <optional>
#include <variant>

#include <fmt/core.h>

#include "config/schema.hpp"
#include "config/values.hpp"

namespace frit::config {
namespace {

bool is_written(const Key& key, const Case& whole) {
  const bool periodic = whole.cell.kind == CellKind::periodic;
  switch (key.applies) {
    case Applies::always:
      return true;
    case Applies::file_packing:
      return whole.packing.file.has_value();
    case Applies::generated_packing:
      return whole.packing.generate.has_value();
    case Applies::random_dense:
      return whole.packing.generate == Generator::random_dense;
    case Applies::periodic:
      return periodic;
    case Applies::periodic_file:
      return periodic && whole.packing.file.has_value();
    case Applies::implicit:
      return whole.method.name != MethodName::verlet;
    case Applies::verlet:
      return whole.method.name == MethodName::verlet;
  }
  return true;
}

std::string comment(const Key& key) {
  const auto unit = info(key.quantity).unit;
  if (!unit.empty()) return fmt::format("  # [{}]", unit);
  if (!key.choices.empty()) return "  # " + allowed_text(key);
  return "  # " + type_text(key);
}

// The items of a list of tables, each as an inline table.
std::string write_items(const Key& list, Case& whole) {
  const auto& access = std::get<ListAccess>(list.slot);
  const std::string prefix = std::string(list.path) + ".";
  std::string items;
  for (std::size_t n = 0; n < access.size(whole); ++n) {
    Target target = access.item(whole, n);
    std::string members;
    for (const Key& key : schema()) {
      const auto value = key.path.starts_with(prefix) ? write_value(key, target) : std::nullopt;
      if (!value) continue;
      members +=
          fmt::format("{}{} = {}", members.empty() ? "" : ", ", key.path.substr(prefix.size()), *value);
    }
    items += fmt::format("{}{{ {} }}", items.empty() ? "" : ", ", members);
  }
  return "[" + items + "]";
}

std::string item_units(const Key& list) {
  const std::string prefix = std::string(list.path) + ".";
  std::string units;
  for (const Key& key : schema()) {
    const auto unit = key.path.starts_with(prefix) ? info(key.quantity).unit : std::string_view();
    if (unit.empty()) continue;
    units += fmt::format("{}{} [{}]", units.empty() ? "" : ", ", key.path.substr(prefix.size()), unit);
  }
  return "  # " + units;
}

bool belongs_to_list(const Key& key) {
  for (auto dot = key.path.find('.'); dot != key.path.npos; dot = key.path.find('.', dot + 1)) {
    const Key* above = find_key(key.path.substr(0, dot));
    if (above && above->type == Type::table_list) return true;
  }
  return false;
}

}  // namespace

std::string write_case(const Case& original, std::string_view version) {
  Case whole = original;
  Target target{.whole = whole};
  std::string root = fmt::format("# Written by frit {}: the resolved case, in SI units.\n", version);
  std::string tables, section;
  for (const Key& key : schema()) {
    const bool list = std::holds_alternative<ListAccess>(key.slot);
    if (belongs_to_list(key) || !is_written(key, whole)) continue;
    const auto value = list ? write_items(key, whole) : write_value(key, target);
    if (!value || (key.path == "material.use" && whole.material.use.empty())) continue;
    const auto dot = key.path.find('.');
    const auto line =
        fmt::format("{} = {}{}\n", key.path.substr(dot + 1), *value, list ? item_units(key) : comment(key));
    if (dot == key.path.npos) {
      root += line;
      continue;
    }
    if (section != key.path.substr(0, dot)) {
      section = key.path.substr(0, dot);
      tables += fmt::format("\n[{}]\n", section);
    }
    tables += line;
  }
  return root + tables;
}

}  // namespace frit::config
