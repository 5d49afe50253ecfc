// Every key of a case file, described once: this table parses, checks, writes and documents it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "config/case.hpp"
#include "config/units.hpp"

namespace frit::config {

enum class Status : std::uint8_t { available, not_available_yet };

enum class Type : std::uint8_t {
  text,
  path,
  boolean,
  integer,
  quantity,          // a number where the quantity is Quantity::number
  vector,            // a list of 3 quantities
  scalar_or_vector,  // one quantity, meaning all three, or a list of 3
  choice,
  choice_list,  // some of the choices, each once, at least one
  integer_list,
  table,
  table_list,
};

enum class Automatic : std::uint8_t { refused, accepted };  // whether "auto" is a value

// Where a key has a meaning; elsewhere only its default is accepted, and it is not written.
enum class Applies : std::uint8_t {
  always,
  file_packing,
  generated_packing,
  random_dense,
  periodic,
  periodic_file,
  implicit,  // methods that solve for their steps
  verlet
};

enum class Edge : std::uint8_t { included, excluded };
struct Bound {
  double value;
  Edge edge = Edge::included;
};
struct Range {
  std::optional<Bound> least{}, most{};
};

struct Choice {
  std::string_view name;
  Status status = Status::available;
};

// What a value is read into: the case, or the item of a list of tables under construction.
struct Target {
  Case& whole;
  TemperatureStep* step = nullptr;
  ParticleGroup* group = nullptr;
};

template <class T>
using Access = T& (*)(Target&);
struct ChoiceAccess {
  std::optional<int> (*get)(Target&);  // index into Key::choices
  void (*set)(Target&, int);
};
struct ChoiceListAccess {
  std::vector<int> (*get)(Target&);  // indices into Key::choices
  void (*set)(Target&, const std::vector<int>&);
};
struct ListAccess {
  std::size_t (*size)(const Case&);
  void (*grow)(Case&);
  Target (*item)(Case&, std::size_t);
};
using Slot =
    std::variant<std::monostate, Access<std::string>, Access<std::optional<std::filesystem::path>>,
                 Access<bool>, Access<std::int64_t>, Access<std::optional<std::int64_t>>, Access<double>,
                 Access<std::optional<double>>, Access<Vec3>, Access<std::optional<Vec3>>,
                 Access<std::vector<std::int64_t>>, ChoiceAccess, ChoiceListAccess, ListAccess>;

struct Key {
  std::string_view path{};  // "contact.pull"; the keys of a list's items are "temperature.program.rate"
  Type type = Type::text;
  Quantity quantity = Quantity::number;
  Slot slot{};                    // empty where nothing is kept yet
  std::string_view fallback{};    // the default, as an override would write it; empty: none
  Range range{};                  // SI; of each component
  std::vector<Choice> choices{};  // in the order of the enumeration
  Automatic automatic = Automatic::refused;
  Applies applies = Applies::always;
  Status status = Status::available;
  std::string_view sentence{};
};

// All keys, section by section in the order of a case file.
std::span<const Key> schema();
const Key* find_key(std::string_view path);

// Whether `path` names a table of the schema ("packing", "material.boundary_diffusion").
bool is_section(std::string_view path);

// Keys and sections directly below `section` ("" is the root), by their last name.
std::vector<std::string> names_in(std::string_view section);
std::vector<std::string> all_paths();

// "a length with unit, e.g. "5 um"", for messages and the reference.
std::string type_text(const Key& key);
// "above 0 m, at most 1 m", the choices, or empty where everything of the type goes.
std::string allowed_text(const Key& key);
// When the key has a meaning, "only with packing.file", or empty.
std::string applies_text(Applies applies);

}  // namespace frit::config
