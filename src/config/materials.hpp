// The built-in materials and where their numbers come from.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "config/case.hpp"

namespace frit::config {

struct BuiltInMaterial {
  Material material;  // SI; `use` holds its name
  std::string_view source;
};

std::span<const BuiltInMaterial> materials();
std::vector<std::string> material_names();

// Nothing where the name is unknown.
std::optional<Material> find_material(std::string_view name);

// The table of materials with their sources, for the terminal.
std::string materials_text();

}  // namespace frit::config
