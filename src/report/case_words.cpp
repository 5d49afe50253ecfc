#include "report/case_words.hpp"

#include <fmt/core.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

#include "config/materials.hpp"
#include "core/constants.hpp"

namespace frit::report {
namespace {

using config::Case;

struct Unit {
  const char* name;
  double size;
};

template <std::size_t count>
std::string in_largest_unit(double value, const std::array<Unit, count>& units) {
  for (const Unit& unit : units) {
    if (std::abs(value) >= 0.9999 * unit.size) return fmt::format("{:.4g} {}", value / unit.size, unit.name);
  }
  return fmt::format("{:.4g} {}", value / units.back().size, units.back().name);
}

std::string packing_words(const Case& whole, std::size_t particles) {
  const std::string material = whole.material.use.empty() ? "" : whole.material.use + " ";
  std::string text = fmt::format("{} {}spheres", particles, material);
  if (whole.packing.file)
    return text + fmt::format(" of the packing {}", whole.packing.file->filename().string());
  text += fmt::format(", mean radius {}", short_length(whole.packing.radius));
  if (whole.packing.radius_spread > 0.0) text += fmt::format(" (spread {:.3g})", whole.packing.radius_spread);
  if (whole.packing.generate == config::Generator::random_dense) {
    return text +
           fmt::format(", random dense packing with relative density {:.3g}", whole.packing.relative_density);
  }
  return text + ", on a lattice";
}

std::string cell_words(const Case& whole) {
  if (whole.cell.kind == config::CellKind::free) return "a free body";
  if (whole.cell.strain_rate) {
    const Vec3& rate = *whole.cell.strain_rate;
    return fmt::format("a periodic cell strained at ({:.3g}, {:.3g}, {:.3g}) 1/s", rate.x(), rate.y(),
                       rate.z());
  }
  const Vec3 stress = whole.cell.stress.value_or(Vec3::Zero());
  if (stress.isZero(0.0)) return "a periodic cell without stress";
  return fmt::format("a periodic cell under ({:.3g}, {:.3g}, {:.3g}) MPa", stress.x() / 1e6, stress.y() / 1e6,
                     stress.z() / 1e6);
}

std::string temperature_words(const Case& whole) {
  std::string text = fmt::format("at {}", short_temperature(whole.temperature.start));
  for (const config::TemperatureStep& step : whole.temperature.program) {
    if (step.hold) {
      text += fmt::format(", held for {}", short_time(*step.hold));
    } else {
      text += fmt::format(", to {} at {:.4g} K/min", short_temperature(*step.to), *step.rate * 60.0);
    }
  }
  return text;
}

std::string stop_words(const Case& whole) {
  std::string text;
  if (whole.stop.relative_density)
    text = fmt::format("relative density {:.4g}", *whole.stop.relative_density);
  if (whole.stop.time) text += (text.empty() ? "" : " or ") + short_time(*whole.stop.time);
  return text;
}

std::string contact_words(const Case& whole) {
  const config::ContactSettings& contact = whole.contact;
  std::string text = contact.attraction == config::Attraction::parhami_mcmeeking
                         ? "Necks with the attraction of Parhami and McMeeking"
                         : "Necks with the attraction of Bouvard and McMeeking";
  text += contact.pull == config::Pull::unilateral ? ", opening when pulled" : ", stretching when pulled";
  text += fmt::format(", sliding resistance eta = {:.4g}", contact.sliding_resistance);
  if (contact.neck_bending) text += ", resisting rolling and twisting";
  if (contact.spins == config::Spins::blocked) text += "; particles cannot rotate";
  return text + ".";
}

std::string method_name(const config::Method& method) {
  switch (method.name) {
    case config::MethodName::contact_dynamics:
      return "Contact dynamics";
    case config::MethodName::quasi_static:
      return "Quasi-static";
    case config::MethodName::mean_field:
      return "Mean field: all move with the strain";
    case config::MethodName::verlet:
      return fmt::format("Explicit dynamics (velocity Verlet) with {:.4g} times the real density",
                         method.density_factor);
  }
  return "";
}

std::string method_words(const config::Method& method) {
  const std::string name = method_name(method);
  if (method.time_step) return fmt::format("{}, time step {}.", name, short_time(*method.time_step));
  if (method.name == config::MethodName::verlet) return name + ", steps at the limit of stability.";
  return fmt::format("{}, steps controlled to an accuracy of {:.3g}.", name, method.accuracy);
}

// The properties that differ from those of the built-in material.
std::string overridden(const config::Material& used, const config::Material& built_in) {
  std::string names;
  const auto compare = [&](const char* name, double a, double b) {
    if (a != b) names += (names.empty() ? "" : ", ") + std::string(name);
  };
  compare("density", used.density, built_in.density);
  compare("surface energy", used.surface_energy, built_in.surface_energy);
  compare("dihedral angle", used.dihedral_angle, built_in.dihedral_angle);
  compare("atomic volume", used.atomic_volume, built_in.atomic_volume);
  compare("diffusion prefactor", used.boundary_diffusion.prefactor, built_in.boundary_diffusion.prefactor);
  compare("activation energy", used.boundary_diffusion.activation_energy,
          built_in.boundary_diffusion.activation_energy);
  return names;
}

std::string source_of(const config::Material& used) {
  for (const config::BuiltInMaterial& built_in : config::materials()) {
    if (built_in.material.use != used.use) continue;
    const std::string changed = overridden(used, built_in.material);
    return std::string(built_in.source) + (changed.empty() ? "" : "; set in the case: " + changed);
  }
  return "set in the case";
}

}  // namespace

std::vector<std::string> case_in_words(const Case& whole, std::size_t particles) {
  return {fmt::format("{}; {}.", packing_words(whole, particles), cell_words(whole)),
          fmt::format("Sintered {}, until {}.", temperature_words(whole), stop_words(whole)),
          contact_words(whole), method_words(whole.method)};
}

nlohmann::json material_of(const Case& whole) {
  const config::Material& material = whole.material;
  nlohmann::json properties = nlohmann::json::array();
  const auto add = [&](const char* name, double value, const char* unit) {
    properties.push_back(nlohmann::json::array({name, fmt::format("{:.5g} {}", value, unit)}));
  };
  add("density", material.density, "kg/m³");
  add("surface energy γ", material.surface_energy, "J/m²");
  add("dihedral angle ψ", material.dihedral_angle * 180.0 / pi, "°");
  add("atomic volume Ω", material.atomic_volume, "m³");
  add("boundary diffusion δD₀", material.boundary_diffusion.prefactor, "m³/s");
  add("activation energy Q", material.boundary_diffusion.activation_energy / 1e3, "kJ/mol");
  return {{"name", material.use.empty() ? "own material" : material.use},
          {"source", source_of(material)},
          {"properties", properties}};
}

std::string short_length(double metres) {
  return in_largest_unit(metres, std::array<Unit, 4>{{{"m", 1.0}, {"mm", 1e-3}, {"µm", 1e-6}, {"nm", 1e-9}}});
}

std::string short_time(double seconds) {
  if (seconds == 0.0) return "0 s";
  return in_largest_unit(
      seconds, std::array<Unit, 5>{{{"h", 3600.0}, {"min", 60.0}, {"s", 1.0}, {"ms", 1e-3}, {"µs", 1e-6}}});
}

std::string short_temperature(double kelvin) { return fmt::format("{:.5g} °C", kelvin - 273.15); }

}  // namespace frit::report
