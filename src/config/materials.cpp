#include "config/materials.hpp"

#include <fmt/core.h>

#include <array>

#include "config/units.hpp"
#include "core/constants.hpp"

namespace frit::config {
namespace {

Material with_angle(Material material, std::string_view angle) {
  material.dihedral_angle = parse_quantity(angle, Quantity::angle);
  return material;
}

const std::array<BuiltInMaterial, 3>& table() {
  static const std::array<BuiltInMaterial, 3> built_in{{
      {with_angle({.use = "copper",
                   .density = 8960,
                   .surface_energy = 1.72,
                   .atomic_volume = 1.18e-29,
                   .melting_temperature = 1357.77,
                   .boundary_diffusion = {.prefactor = 5.12e-15, .activation_energy = 105e3}},
                  "146 deg"),
       "Swinkels & Ashby 1981 (Frost & Ashby 1982 give 5.0e-15 m^3/s and 104 kJ/mol); melting: ITS-90"},
      {with_angle({.use = "nickel",
                   .density = 8908,
                   .surface_energy = 2.0,
                   .atomic_volume = 1.09e-29,
                   .melting_temperature = 1728,
                   .boundary_diffusion = {.prefactor = 3.5e-15, .activation_energy = 232e3}},
                  "146 deg"),
       "Z. Yan, thesis, TU Darmstadt and Grenoble, 2013, table 6.1 (the activation energy is a fit); "
       "melting: NIST-JANAF tables (Chase 1998)"},
      {with_angle({.use = "alumina",
                   .density = 3980,
                   .surface_energy = 1.1,
                   .atomic_volume = 8.47e-30,
                   .melting_temperature = 2327,
                   .boundary_diffusion = {.prefactor = 1.3e-8, .activation_energy = 475e3}},
                  "120 deg"),
       "Wonisch et al. 2007, as quoted by Z. Yan 2013 (the dihedral angle is assumed); "
       "melting: NIST-JANAF tables (Chase 1998)"},
  }};
  return built_in;
}

}  // namespace

std::span<const BuiltInMaterial> materials() { return table(); }

std::vector<std::string> material_names() {
  std::vector<std::string> names;
  for (const auto& built_in : materials()) names.push_back(built_in.material.use);
  return names;
}

std::optional<Material> find_material(std::string_view name) {
  for (const auto& built_in : materials())
    if (built_in.material.use == name) return built_in.material;
  return std::nullopt;
}

std::string materials_text() {
  std::string text = "Built-in materials: material.use = \"NAME\"; any property given beside it overrides.\n";
  for (const auto& [material, source] : materials()) {
    text += fmt::format("\n{}\n", material.use);
    text += fmt::format("  density             {:.6g} kg/m^3\n", material.density);
    text += fmt::format("  surface_energy      {:.6g} J/m^2\n", material.surface_energy);
    text += fmt::format("  dihedral_angle      {:.6g} deg\n", material.dihedral_angle * 180.0 / pi);
    text += fmt::format("  atomic_volume       {:.6g} m^3\n", material.atomic_volume);
    text += fmt::format("  melting_temperature {:.6g} K\n", material.melting_temperature.value_or(0.0));
    text += fmt::format("  boundary_diffusion  {:.6g} m^3/s * exp(-{:.6g} kJ/mol / (R_gas T))\n",
                        material.boundary_diffusion.prefactor,
                        material.boundary_diffusion.activation_energy / 1e3);
    text += fmt::format("  source: {}\n", source);
  }
  return text;
}

}  // namespace frit::config
