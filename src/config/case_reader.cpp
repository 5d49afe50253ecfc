#include "config/case_reader.hpp"

#include <fmt/core.h>
#include <array>
#include <system_error>
#include <utility>
#include <variant>

#include <fstream>
#include <optional>

#include "config/case_checks.hpp"
#include "config/faults.hpp"
#include "config/materials.hpp"
#include "config/nearest.hpp"
#include "config/schema.hpp"
#include "config/toml_reader.hpp"
#include "config/toml_screen.hpp"
#include "config/values.hpp"
#include "core/error.hpp"

namespace frit::config {
namespace {

std::string joined(std::string_view prefix, std::string_view name) {
  return prefix.empty() ? std::string(name) : fmt::format("{}.{}", prefix, name);
}

// Walks the document and reads every key into the case.
class Walk {
 public:
  Walk(Case& whole, Given& given, Faults& faults) : whole_(whole), given_(given), faults_(faults) {}

  // `path` finds the keys in the schema, `shown` names them in faults (with the index of a list's item).
  struct Section {
    std::string path, shown;
  };

  void read_table(const Table& table, const Section& section, Target& target) {
    for (const Entry& entry : table.entries)
      read_entry(entry, {joined(section.path, entry.key), joined(section.shown, entry.key)}, target);
  }

 private:
  void read_entry(const Entry& entry, const Section& at, Target& target) {
    const Key* key = find_key(at.path);
    if (!key && !is_section(at.path)) return report_unknown(entry, at);
    given_[at.shown] = entry.place;
    if (key && std::holds_alternative<std::monostate>(key->slot))
      return faults_.add(entry.place, at.shown, "not available yet; leave it out");
    if (key && key->type == Type::table_list) return read_list(entry, at, std::get<ListAccess>(key->slot));
    if (key) return read_key(*key, entry, at, target);
    if (const auto* table = entry.node.as<Table>()) return read_table(*table, at, target);
    faults_.add(entry.place, at.shown,
                fmt::format("a table is wanted; allowed is [{}] with its keys", at.path));
  }

  void read_key(const Key& key, const Entry& entry, const Section& at, Target& target) {
    try {
      read_value(key, entry.node, target);
    } catch (const InputError& fault) {
      faults_.add(entry.node.place, at.shown, fault.what());
    }
  }

  void read_list(const Entry& entry, const Section& at, const ListAccess& access) {
    const auto* list = entry.node.as<List>();
    const auto complain = [&](Place place, const std::string& shown) {
      faults_.add(place, shown,
                  fmt::format("a list of tables is wanted; allowed are {} = [{{ ... }}] or [[{}]]", at.path,
                              at.path));
    };
    if (!list) return complain(entry.place, at.shown);
    for (std::size_t n = 0; n < list->items.size(); ++n) {
      const Node& item = list->items[n];
      const std::string shown = fmt::format("{}[{}]", at.shown, n);
      access.grow(whole_);
      given_[shown] = item.place;
      Target target = access.item(whole_, n);
      if (const auto* table = item.as<Table>()) {
        read_table(*table, {at.path, shown}, target);
      } else {
        complain(item.place, shown);
      }
    }
  }

  // The key of another section with the nearest last name.
  static std::string did_you_mean_elsewhere(const std::string& name) {
    const auto last_name = [](const std::string& path) { return path.substr(path.rfind('.') + 1); };
    std::vector<std::string> names;
    for (const std::string& path : all_paths()) names.push_back(last_name(path));
    const auto near = nearest(name, names, 1);
    if (near.empty()) return "";
    for (const std::string& path : all_paths())
      if (last_name(path) == near.front()) return fmt::format("; did you mean {}?", path);
    return "";
  }

  // Names the nearest key of the section, or, where none is near, of the whole schema.
  void report_unknown(const Entry& entry, const Section& at) {
    const auto dot = at.path.rfind('.');
    const std::string section = dot == std::string::npos ? "" : at.path.substr(0, dot);
    const auto siblings = names_in(section);
    auto hint = did_you_mean(entry.key, siblings);
    if (hint.empty()) hint = did_you_mean_elsewhere(entry.key);
    std::string names;
    for (const auto& name : siblings) names += (names.empty() ? "" : ", ") + name;
    faults_.add(entry.place, at.shown.substr(0, 200),
                fmt::format("unknown key{}; allowed here: {}", hint, names));
  }

  Case& whole_;
  Given& given_;
  Faults& faults_;
};

// Puts the override's value where its key says, replacing what stands there.
void apply_override(Table& document, const std::string& text, int index, Faults& faults) {
  const Place place{.line = 0, .override_index = index};
  const auto equals = text.find('=');
  const auto strip = [](std::string_view part) {
    const auto begin = part.find_first_not_of(" \t");
    return begin == part.npos ? std::string_view()
                              : part.substr(begin, part.find_last_not_of(" \t") - begin + 1);
  };
  std::string_view path = strip(std::string_view(text).substr(0, equals));
  if (equals == std::string::npos || path.empty())
    return faults.add(place, "", "no value; allowed is key=value, e.g. stop.time=2h");
  const std::string shown(path);
  if (fmt::format(".{}.", path).find("..") != std::string::npos)
    return faults.add(place, shown, "an empty name between dots; allowed is key=value, e.g. stop.time=2h");
  Table* table = &document;
  for (auto dot = path.find('.'); dot != path.npos; dot = path.find('.')) {
    const std::string name(path.substr(0, dot));
    path.remove_prefix(dot + 1);
    Entry* entry = table->find(name);
    if (!entry) entry = &table->entries.emplace_back(Entry{name, place, {Table{}, place}});
    table = entry->node.as<Table>();
    if (!table)
      return faults.add(place, shown, fmt::format("\"{}\" is not a table here; give the whole of it", name));
  }
  try {
    Node value = read_toml_value(strip(std::string_view(text).substr(equals + 1)), place);
    if (Entry* entry = table->find(path)) {
      *entry = {entry->key, place, std::move(value)};
    } else {
      table->entries.push_back({std::string(path), place, std::move(value)});
    }
  } catch (const TextFault& fault) {
    faults.add(place, shown, fmt::format("not TOML: {}", fault.what()));
  }
}

// The properties of the material in use, before the keys beside it override them.
void start_from_material(const Table& document, Case& whole, Faults& faults) {
  const Entry* section = document.find("material");
  const Table* table = section ? section->node.as<Table>() : nullptr;
  const Entry* use = table ? table->find("use") : nullptr;
  const auto* name = use ? use->node.as<std::string>() : nullptr;
  if (!name) return;
  if (const auto material = find_material(*name)) {
    whole.material = *material;
    return;
  }
  std::string known;
  for (const auto& built_in : material_names())
    known += fmt::format("{}\"{}\"", known.empty() ? "" : ", ", built_in);
  faults.add(use->node.place, "material.use",
             fmt::format("\"{}\" is unknown{}; allowed: {}", name->substr(0, 80),
                         did_you_mean(*name, material_names()), known));
}

void anchor_path(std::optional<std::filesystem::path>& path, const std::filesystem::path& folder) {
  if (path) path = (folder / *path).lexically_normal();
}

std::string read_text_file(const std::filesystem::path& path) {
  std::error_code error;
  const auto complain = [&](const std::string& what) {
    return InputError(fmt::format("{}: {}; a case file (TOML) is wanted", path.string(), what));
  };
  if (!std::filesystem::exists(path, error)) throw complain("there is no such file");
  if (std::filesystem::is_directory(path, error)) throw complain("this is a folder");
  std::ifstream file(path, std::ios::binary);
  if (!file) throw complain("the file cannot be opened (are you allowed to read it?)");
  std::string text;
  std::array<char, 65536> piece;
  while (text.size() <= largest_text && file) {
    file.read(piece.data(), piece.size());
    text.append(piece.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (file.bad()) throw complain("the file cannot be read");
  return text;
}

}  // namespace

Case default_case() {
  static const Case defaults = [] {
    Case whole;
    Target target{.whole = whole};
    for (const Key& key : schema()) {
      if (key.fallback.empty() || key.type == Type::table_list || key.path.starts_with("particles."))
        continue;
      read_value(key, read_toml_value(key.fallback, {}), target);
    }
    return whole;
  }();
  return defaults;
}

Case parse_case(std::string_view text, const std::string& name, const std::vector<std::string>& overrides) {
  Faults faults(name, overrides);
  Table document;
  try {
    document = read_toml(text);
  } catch (const TextFault& fault) {
    faults.add({.line = fault.line()}, "", fmt::format("not TOML: {}", fault.what()));
  }
  faults.throw_if_any();
  for (std::size_t n = 0; n < overrides.size(); ++n)
    apply_override(document, overrides[n], static_cast<int>(n), faults);

  Case whole = default_case();
  Given given;
  start_from_material(document, whole, faults);
  Target target{.whole = whole};
  Walk(whole, given, faults).read_table(document, {}, target);
  check_case(whole, given, faults);
  faults.throw_if_any();

  resolve_case(whole, given);
  const auto folder = std::filesystem::absolute(name).parent_path();
  anchor_path(whole.packing.file, folder);
  anchor_path(whole.packing.contacts, folder);
  return whole;
}

Case load_case(const std::filesystem::path& path, const std::vector<std::string>& overrides) {
  return parse_case(read_text_file(path), path.string(), overrides);
}

}  // namespace frit::config
