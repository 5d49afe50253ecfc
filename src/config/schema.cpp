#include "config/schema.hpp"

#include <fmt/core.h>

#include <algorithm>

namespace frit::config {

const Key* find_key(std::string_view path) {
  for (const Key& key : schema())
    if (key.path == path) return &key;
  return nullptr;
}

bool is_section(std::string_view path) {
  const std::string prefix = std::string(path) + ".";
  for (const Key& key : schema())
    if (key.path.starts_with(prefix)) return true;
  return false;
}

std::vector<std::string> names_in(std::string_view section) {
  const std::string prefix = section.empty() ? "" : std::string(section) + ".";
  std::vector<std::string> names;
  for (const Key& key : schema()) {
    if (!key.path.starts_with(prefix)) continue;
    const auto rest = key.path.substr(prefix.size());
    std::string name(rest.substr(0, rest.find('.')));
    if (std::find(names.begin(), names.end(), name) == names.end()) names.push_back(std::move(name));
  }
  return names;
}

std::vector<std::string> all_paths() {
  std::vector<std::string> paths;
  for (const Key& key : schema()) paths.emplace_back(key.path);
  return paths;
}

namespace {
std::string quantity_text(const Key& key) {
  const QuantityInfo& wanted = info(key.quantity);
  if (key.quantity == Quantity::number) return "a number";
  return fmt::format("{} with its unit, e.g. \"{}\", or a number in {}", wanted.name, wanted.example,
                     wanted.unit);
}

std::string list_text(const Key& key) {
  const QuantityInfo& wanted = info(key.quantity);
  return fmt::format("a list of 3, for x, y and z: each {} with its unit, e.g. \"{}\", or a number in {}",
                     wanted.name, wanted.example, wanted.unit);
}

std::string plain_type_text(const Key& key) {
  switch (key.type) {
    case Type::text:
      return "a text in quotation marks";
    case Type::path:
      return "a file name in quotation marks";
    case Type::boolean:
      return "true or false";
    case Type::integer:
      return "a whole number";
    case Type::quantity:
      return quantity_text(key);
    case Type::vector:
      return list_text(key);
    case Type::scalar_or_vector:
      return quantity_text(key) + "; or " + list_text(key);
    case Type::choice:
      return "one of some names in quotation marks";
    case Type::choice_list:
      return "a list of names in quotation marks, each once";
    case Type::integer_list:
      return "a list of whole numbers";
    case Type::table:
      return "a table";
    case Type::table_list:
      return "a list of tables";
  }
  return {};
}
}  // namespace

std::string type_text(const Key& key) {
  return plain_type_text(key) + (key.automatic == Automatic::accepted ? ", or \"auto\"" : "");
}

std::string allowed_text(const Key& key) {
  if (key.type == Type::choice || key.type == Type::choice_list) {
    std::string names;
    for (const Choice& choice : key.choices) {
      const auto note = choice.status == Status::not_available_yet ? " (not available yet)" : "";
      names += fmt::format("{}\"{}\"{}", names.empty() ? "" : ", ", choice.name, note);
    }
    return names;
  }
  const auto bare_unit = info(key.quantity).unit;
  const std::string unit = bare_unit.empty() ? "" : fmt::format(" {}", bare_unit);
  std::string text;
  if (const auto& least = key.range.least)
    text +=
        fmt::format("{} {:.10g}{}", least->edge == Edge::excluded ? "above" : "at least", least->value, unit);
  if (const auto& most = key.range.most)
    text += fmt::format("{}{} {:.10g}{}", text.empty() ? "" : ", ",
                        most->edge == Edge::excluded ? "below" : "at most", most->value, unit);
  return text;
}

std::string applies_text(Applies applies) {
  switch (applies) {
    case Applies::always:
      return "";
    case Applies::file_packing:
      return "only with packing.file";
    case Applies::generated_packing:
      return "only with packing.generate";
    case Applies::random_dense:
      return "only with packing.generate = \"random-dense\"";
    case Applies::periodic:
      return "only with cell.kind = \"periodic\"";
    case Applies::periodic_file:
      return "only with cell.kind = \"periodic\" and packing.file";
    case Applies::implicit:
      return "not with method.name = \"verlet\"";
    case Applies::verlet:
      return "only with method.name = \"verlet\"";
  }
  return {};
}

}  // namespace frit::config
