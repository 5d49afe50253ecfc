// From a case to everything a run starts from: state, law, furnace, limits of the step, reference.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "config/case.hpp"
#include "integrate/implicit_step.hpp"
#include "integrate/step_control.hpp"
#include "integrate/stepper.hpp"
#include "integrate/temperature.hpp"
#include "observe/reference.hpp"
#include "run/translate.hpp"
#include "state/state.hpp"

namespace frit::run {

struct Setup {
  config::Case whole;
  State state;  // particles along the Morton curve, first contacts found
  integrate::StepSettings settings;
  Heating heating;
  integrate::Furnace furnace;
  integrate::StepLimits limits;
  observe::Reference reference;       // the start
  double density = 0.0;               // relative, at the start; NaN without a core
  double time_scale = 0.0;            // R^4/(gamma Delta_b) [s] at the hottest temperature; infinity at 0 K
  std::vector<std::string> warnings;  // what a user should know, a sentence each

  // Dimensionless time tau of a stretch of the run: its integral of Delta_b times gamma/R^4.
  double tau_of(double theta) const;
};

// Throws InputError with every fault of the packing, its contacts and its groups, and of what the case asks
// of them; Abandoned where `abandon`, asked while a packing is made, says so.
Setup make_setup(const config::Case& whole, const std::function<bool()>& abandon = {});
// The same from a start that is known, with its particles along the curve and its first contacts.
Setup make_setup(const config::Case& whole, State start);

// What advances the states of this run: by implicit or by explicit steps. The setup must outlive it.
std::unique_ptr<integrate::Stepper> make_stepper(const Setup& setup);

// R^4/(gamma Delta_b) [s] of the mean radius; infinity where nothing diffuses.
double time_scale_of(double mean_radius, double surface_energy, double delta_b);

}  // namespace frit::run
