#include "run/setup.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>

#include "contact/detection.hpp"
#include "core/error.hpp"
#include "network/step_problem.hpp"
#include "observe/density.hpp"
#include "run/morton.hpp"
#include "run/packing.hpp"
#include "run/setup_checks.hpp"

namespace frit::run {
namespace {

// Below this share of the time scale a step cannot help any more.
constexpr double smallest_step_share = 1e-18;
// A fixed step that must be halved below this share of what was asked for is not what was asked for.
constexpr double smallest_fixed_share = 1e-6;

void throw_if_any(const FaultTexts& faults) {
  if (!faults.empty()) throw InputError(faults);
}

std::optional<contact::GivenNecks> collect_necks(const config::Case& whole, std::size_t count,
                                                 FaultTexts& faults) {
  try {
    return read_given_necks(whole, count);
  } catch (const InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    return std::nullopt;
  }
}

// Rows of the user become rows along the curve.
void rename_rows(const std::vector<std::int32_t>& order, contact::GivenNecks& necks) {
  std::vector<std::int32_t> new_row(order.size());
  for (std::size_t n = 0; n < order.size(); ++n) {
    new_row[static_cast<std::size_t>(order[n])] = static_cast<std::int32_t>(n);
  }
  for (auto& pair : necks.pairs) {
    for (std::int32_t& row : pair) row = new_row[static_cast<std::size_t>(row)];
  }
}

State make_state(const config::Case& whole, const contact::SinteringLaw& law,
                 const std::function<bool()>& abandon) {
  FaultTexts faults;
  generate::Packing packing = make_packing(whole, abandon);
  check_spheres(whole, packing, faults);
  std::optional<contact::GivenNecks> necks = collect_necks(whole, packing.particles.size(), faults);
  throw_if_any(faults);
  const std::vector<std::int32_t> order = morton_order(packing.particles);
  State state;
  state.particles = reordered(packing.particles, order);
  state.cell = packing.cell;
  if (necks) {
    rename_rows(order, *necks);
    contact::use_given_contacts(state, law, *necks, whole.contact.initial_neck_ratio);
  } else {
    contact::find_initial_contacts(state, law, whole.contact.initial_neck_ratio);
  }
  return state;
}

integrate::StepLimits limits_of(const config::Method& method, double time_scale) {
  integrate::StepLimits limits;
  if (method.name == config::MethodName::verlet) return limits;
  limits.fixed = method.time_step;
  limits.accuracy = method.accuracy;
  limits.largest = method.largest_step.value_or(limits.largest);
  const double floor = std::isfinite(time_scale) ? smallest_step_share * time_scale : 0.0;
  limits.smallest = method.smallest_step.value_or(floor);
  if (limits.fixed) limits.smallest = smallest_fixed_share * *limits.fixed;
  return limits;
}

}  // namespace

double time_scale_of(double mean_radius, double surface_energy, double delta_b) {
  if (!(delta_b > 0.0)) return std::numeric_limits<double>::infinity();
  return std::pow(mean_radius, 4) / (surface_energy * delta_b);
}

double Setup::tau_of(double theta) const {
  return theta * settings.law.surface_energy / std::pow(reference.mean_radius, 4);
}

std::unique_ptr<integrate::Stepper> make_stepper(const Setup& setup) {
  if (setup.whole.method.name == config::MethodName::verlet) {
    return std::make_unique<integrate::VerletStep>(verlet_settings_of(setup.whole), setup.furnace);
  }
  return std::make_unique<integrate::ImplicitStep>(setup.settings, setup.furnace);
}

Setup make_setup(const config::Case& whole, const std::function<bool()>& abandon) {
  State start = make_state(whole, step_settings_of(whole).law, abandon);
  start.temperature = heating_of(whole).start;
  return make_setup(whole, std::move(start));
}

Setup make_setup(const config::Case& whole, State state) {
  FaultTexts faults;
  const integrate::StepSettings settings = step_settings_of(whole);
  const Heating heating = heating_of(whole);
  observe::Reference reference = observe::take_reference(state);
  const double density = observe::relative_density(reference, state);
  check_contacts(whole, state, faults);
  check_stop(whole, reference, density, faults);
  throw_if_any(faults);

  const double length = network::scale_of(state.particles, settings.law).length;
  const double time_scale =
      time_scale_of(length, settings.law.surface_energy, heating.diffusion.delta_b(heating.hottest));
  std::vector<std::string> warnings = find_warnings(whole, state, density);
  if (auto melting = warn_of_melting(whole, heating)) warnings.push_back(std::move(*melting));
  const double hottest = heating.diffusion.delta_b(heating.hottest);
  if (auto inertia = warn_of_inertia(whole, state, hottest)) warnings.push_back(std::move(*inertia));
  return {.whole = whole,
          .state = std::move(state),
          .settings = settings,
          .heating = heating,
          .furnace = integrate::Furnace(heating.diffusion, heating.start, heating.ramps),
          .limits = limits_of(whole.method, time_scale),
          .reference = std::move(reference),
          .density = density,
          .time_scale = time_scale,
          .warnings = std::move(warnings)};
}

}  // namespace frit::run
