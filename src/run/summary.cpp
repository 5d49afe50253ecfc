#include "run/summary.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/parallel.hpp"
#include "run/machine.hpp"

namespace frit::run {
namespace {

using nlohmann::json;

json times_of(const StageClock& clock, double StageClock::Times::*kind) {
  return {{"total", clock.total().*kind},
          {"setup", clock.spent(Stage::setup).*kind},
          {"step", clock.spent(Stage::step).*kind},
          {"observe", clock.spent(Stage::observe).*kind},
          {"output", clock.spent(Stage::output).*kind}};
}

const char* text_of(contact::Attraction attraction) {
  return attraction == contact::Attraction::parhami_mcmeeking ? "parhami-mcmeeking" : "bouvard-mcmeeking";
}
const char* text_of(contact::Pull pull) {
  return pull == contact::Pull::unilateral ? "unilateral" : "bilateral";
}

json energy_of(const integrate::Work& work) {
  return {{"surface_energy_released", work.released},
          {"work_of_cell", work.cell},
          {"work_of_loads", work.load},
          {"dissipated_by_approach", work.approach},
          {"dissipated_by_sliding", work.sliding},
          {"dissipated_by_rolling_and_twisting", work.bending},
          {"kinetic", work.inertia},
          {"imbalance", work.imbalance}};
}

}  // namespace

json json_of(const observe::Row& row) {
  json object = json::object();
  for (const observe::Column& column : row) {
    object[column.name] = std::isfinite(column.value) ? json(column.value) : json();
  }
  return object;
}

json summary_of(const Setup& setup, const EndView& end) {
  const Machine machine = this_machine();
  const Totals& totals = end.totals;
  json summary;
  summary["version"] = version();
  summary["title"] = setup.whole.title;
  summary["exit"] = {{"code", end.ending.code}, {"reason", end.ending.reason}};
  summary["steps"] = totals.steps;
  summary["rejected_steps"] = totals.rejected_steps;
  summary["fitting_attempts"] = totals.fitting_attempts;
  summary["newton_iterations"] = totals.newton_iterations;
  summary["solver_iterations"] = totals.solver_iterations;
  summary["linear_solves"] = {{"block_jacobi", totals.linear_solves.block_jacobi},
                              {"with_coarse_level", totals.linear_solves.with_coarse_level},
                              {"factored", totals.linear_solves.factored},
                              {"in_double", totals.linear_solves.in_double}};
  summary["step_wall_s"] = {{"search", totals.times.search},
                            {"problem", totals.times.problem},
                            {"newton", totals.times.newton},
                            {"linear", totals.times.linear},
                            {"sweep", totals.times.sweep}};
  summary["largest_residual"] = totals.largest_residual;
  summary["accuracy_asked"] = setup.whole.method.time_step ? json() : json(setup.whole.method.accuracy);
  summary["accuracy_estimated"] = totals.accuracy();
  summary["energy_J"] = energy_of(totals.work);
  summary["wall_s"] = times_of(end.clock, &StageClock::Times::wall);
  summary["cpu_s"] = times_of(end.clock, &StageClock::Times::cpu);
  summary["peak_memory_bytes"] = peak_memory_bytes();
  summary["peak_memory_by_stage_bytes"] = {{"setup", end.clock.peak_memory(Stage::setup)},
                                           {"step", end.clock.peak_memory(Stage::step)},
                                           {"observe", end.clock.peak_memory(Stage::observe)},
                                           {"output", end.clock.peak_memory(Stage::output)}};
  summary["particles"] = setup.state.particles.size();
  summary["mean_radius_m"] = setup.reference.mean_radius;
  summary["surface_energy_J_per_m2"] = setup.settings.law.surface_energy;
  summary["seed"] = setup.whole.packing.seed;
  summary["threads"] = threads();
  summary["machine"] = {{"cpu", machine.cpu}, {"cores", machine.cores}};
  summary["attraction"] = text_of(setup.settings.law.attraction);
  summary["pull"] = text_of(setup.settings.law.pull);
  summary["warnings"] = setup.warnings;
  summary["final"] = json_of(end.row);
  return summary;
}

}  // namespace frit::run
