#include "run/translate.hpp"

#include <algorithm>

namespace frit::run {
namespace {

contact::SinteringLaw law_of(const config::Case& whole) {
  const config::ContactSettings& asked = whole.contact;
  contact::SinteringLaw law;
  law.surface_energy = whole.material.surface_energy;
  law.dihedral_angle = whole.material.dihedral_angle;
  law.sliding_resistance = asked.sliding_resistance;
  law.birth_neck_ratio = asked.birth_neck_ratio;
  law.attraction = asked.attraction == config::Attraction::parhami_mcmeeking
                       ? contact::Attraction::parhami_mcmeeking
                       : contact::Attraction::bouvard_mcmeeking;
  law.pull = asked.pull == config::Pull::unilateral ? contact::Pull::unilateral : contact::Pull::bilateral;
  law.closing = asked.closing == config::Closing::rigid ? contact::Closing::rigid : contact::Closing::viscous;
  law.equilibrium_radius = asked.equilibrium_radius == config::EquilibriumRadius::smaller
                               ? contact::EquilibriumRadius::smaller
                               : contact::EquilibriumRadius::equivalent;
  law.neck_bending = asked.neck_bending;
  return law;
}

network::Inertia inertia_of(const config::Method& method) {
  if (method.name == config::MethodName::quasi_static) return network::Inertia::vanishing;
  return method.inertia == config::Inertia::dynamic ? network::Inertia::dynamic
                                                    : network::Inertia::overdamped;
}

}  // namespace

integrate::StepSettings step_settings_of(const config::Case& whole) {
  const config::Method& method = whole.method;
  integrate::StepSettings settings;
  settings.law = law_of(whole);
  settings.inertia = inertia_of(method);
  if (method.name == config::MethodName::mean_field) settings.freedom = network::Freedom::affine;
  if (method.solver == config::Solver::gauss_seidel) settings.solver = integrate::Solver::gauss_seidel;
  settings.spins_blocked = whole.contact.spins == config::Spins::blocked;
  settings.accuracy = method.accuracy;
  settings.error_controls_step = !method.time_step.has_value();
  settings.tolerance = method.tolerance.value_or(std::min(5e-5, 5e-3 * method.accuracy));
  settings.stress = whole.cell.stress.value_or(Vec3::Zero());
  settings.strain_rate = whole.cell.strain_rate;
  return settings;
}

integrate::VerletSettings verlet_settings_of(const config::Case& whole) {
  integrate::VerletSettings settings;
  settings.law = law_of(whole);
  settings.spins_blocked = whole.contact.spins == config::Spins::blocked;
  settings.density_factor = whole.method.density_factor;
  settings.cell_inertia = whole.method.cell_inertia;
  settings.time_step = whole.method.time_step;
  settings.stress = whole.cell.stress.value_or(Vec3::Zero());
  settings.strain_rate = whole.cell.strain_rate;
  return settings;
}

Heating heating_of(const config::Case& whole) {
  Heating heating;
  heating.diffusion = {whole.material.atomic_volume, whole.material.boundary_diffusion.prefactor,
                       whole.material.boundary_diffusion.activation_energy};
  heating.start = heating.hottest = whole.temperature.start;
  double now = heating.start, time = 0.0;
  for (const config::TemperatureStep& step : whole.temperature.program) {
    integrate::Ramp ramp{step.hold.value_or(0.0), 0.0};
    if (step.rate && step.to) ramp = {(*step.to - now) / *step.rate, *step.rate};
    if (!(ramp.duration > 0.0)) continue;  // a ramp to where it starts
    now = step.to.value_or(now);
    time += ramp.duration;
    heating.hottest = std::max(heating.hottest, now);
    heating.ramps.push_back(ramp);
    heating.ramp_ends.push_back(time);
  }
  return heating;
}

}  // namespace frit::run
