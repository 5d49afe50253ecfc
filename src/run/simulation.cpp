#include "run/simulation.hpp"

#include <fmt/core.h>

#include <cmath>
#include <utility>

#include "observe/density.hpp"
#include "run/neck_law.hpp"

namespace frit::run {
namespace {

constexpr int not_computed = 3, out_of_time = 4;
constexpr int stopped_by_signal = 128;  // the signal's number is added

// A stretch of dimensionless time in which nothing moves, and one in which something must have.
constexpr double frozen_tau = 1e-30, patient_tau = 10.0;
// Relative change of the density that is one.
constexpr double least_change = 1e-8;
// A step may be this much longer than proposed, relative, to end at a time that must be hit.
constexpr double stretch = 1e-9;
// Spheres that fill more than their cell are no packing of anything.
constexpr double full_density = 1.0;
// Relative difference of two times that are one.
constexpr double round_off = 1e-15;

// The duration after `from` that ends at `to` to the last bit, as far as there is one.
double duration_between(double from, double to) {
  double duration = to - from;
  for (int nudge = 0; nudge < 2 && from + duration != to; ++nudge) {
    duration = std::nextafter(duration, from + duration < to ? HUGE_VAL : 0.0);
  }
  return duration;
}

}  // namespace

Simulation::Simulation(const Setup& setup, StageClock& clock, Requests requests)
    : setup_(setup),
      clock_(clock),
      watch_(std::move(requests), setup.whole.output.checkpoint_every_steps),
      stepper_(make_stepper(setup)),
      control_(setup.limits, stepper_->first_duration(setup.state)),
      schedule_(setup.whole.output, setup.whole.stop, setup.heating.ramp_ends, setup.density),
      state_(setup.state),
      density_(setup.density),
      last_change_{setup.density, setup.state.theta} {
  stepper_->abandon_when([this] { return gives_up_step(); });
}

void Simulation::go_on_from(State state, const Progress& progress) {
  state_ = std::move(state);
  control_.go_on_from(progress.proposed_duration);
  schedule_.go_on_from(progress.output_level);
  density_ = progress.density;
  last_change_ = {progress.changed_density, progress.changed_theta};
  totals_ = progress.totals;
  row_step_ = progress.row_step;
  watch_.lap(totals_.steps);
  is_resumed_ = true;
}

Progress Simulation::progress() const {
  return {.density = density_,
          .proposed_duration = control_.proposed(),
          .output_level = schedule_.level(),
          .changed_density = last_change_.density,
          .changed_theta = last_change_.theta,
          .row_step = row_step_,
          .totals = totals_};
}

std::optional<Ending> reached_stop(const config::Stop& stop, double time, double density) {
  if (stop.time && time >= *stop.time) return Ending{0, "stop.time is reached"};
  if (stop.relative_density && density >= *stop.relative_density * (1.0 - density_tolerance))
    return Ending{0, "stop.relative_density is reached"};
  return std::nullopt;
}

std::optional<Ending> Simulation::reached_end() const {
  if (auto ending = reached_stop(setup_.whole.stop, state_.time, density_)) return ending;
  if (density_ >= full_density * (1.0 - density_tolerance)) {
    return Ending{
        not_computed,
        fmt::format("the relative density has reached {:.6g} at {:.6g} s: the spheres would fill more "
                    "than there is room (their overlaps count twice, and pores had closed long before); "
                    "allowed: stop.relative_density of at most 1, an earlier stop.time, or less pressure",
                    density_, state_.time)};
  }
  if (const int signal = watch_.signal(); signal != 0)
    return Ending{stopped_by_signal + signal, fmt::format("stopped by signal {}", signal)};
  if (watch_.runs_out()) return Ending{out_of_time, "--max-wall would pass in the next step"};
  return why_nothing_moves();
}

std::optional<Ending> Simulation::why_nothing_moves() const {
  const config::Stop& stop = setup_.whole.stop;
  const double T = setup_.heating.hottest;
  if (stop.time ? setup_.tau_of(setup_.furnace.theta(0.0, *stop.time)) < frozen_tau
                : !(setup_.heating.diffusion.delta_b(T) > 0.0)) {
    return Ending{not_computed,
                  fmt::format("nothing diffuses: Delta_b is {:.3g} m^5/(N s) at {:.6g} K, the hottest "
                              "of the programme, so no contact moves",
                              setup_.heating.diffusion.delta_b(T), T)};
  }
  if (!stop.time && setup_.tau_of(state_.theta - last_change_.theta) > patient_tau) {
    return Ending{
        not_computed,
        fmt::format("stop.relative_density = {:.6g} is out of reach: the density stays at {:.6g}, no "
                    "contact moves any more",
                    stop.relative_density.value_or(0.0), density_)};
  }
  return std::nullopt;
}

double Simulation::duration_to_try() const {
  const double hit = schedule_.next_hit(state_.time), left = hit - state_.time;
  const double proposed = control_.proposed();
  if (proposed >= left * (1.0 - stretch)) return duration_between(state_.time, hit);
  // Two halves rather than a long step and a sliver.
  if (!setup_.limits.fixed && proposed > 0.5 * left) return 0.5 * left;
  return proposed;
}

// Whether it is too cold for anything to move within the duration, other than by inertia or a moving cell.
bool Simulation::is_frozen(double duration) const {
  if (setup_.settings.strain_rate || setup_.settings.inertia == network::Inertia::dynamic) return false;
  return setup_.tau_of(setup_.furnace.theta(state_.time, state_.time + duration)) < frozen_tau;
}

Landing Simulation::waited(double duration) const {
  Landing landing{{}, state_, density_};
  landing.report.duration = duration;
  landing.state.time += duration;
  landing.state.temperature = setup_.furnace.temperature(landing.state.time);
  return landing;
}

// Asked within a step. What is asked of the run meanwhile is done with the state before the step.
bool Simulation::gives_up_step() {
  if (watch_.takes_checkpoint_at_once()) {
    clock_.enter(Stage::output);
    for (RunListener* listener : listeners_) listener->checkpoint_due({state_, before_step_});
    clock_.enter(Stage::step);
  }
  return watch_.signal() != 0 || watch_.is_out();
}

bool Simulation::attempt(double duration, Landing& landing) {
  const integrate::Stretch stretch(duration, schedule_.steps_left(totals_.steps));
  landing.report = stepper_->attempt(state_, stretch, landing.state);
  totals_.count_attempt(landing.report);
  if (landing.report.verdict == integrate::Verdict::abandoned) is_step_given_up_ = true;
  if (landing.report.verdict != integrate::Verdict::accepted) return false;
  landing.density = observe::relative_density(setup_.reference, landing.state);
  return true;
}

// A step of the duration, or a shorter one that ends at the stop's density. False: it must be repeated.
bool Simulation::take_step(double duration, Landing& landing) {
  before_step_ = progress();
  const bool accepted = attempt(duration, landing);
  last_report_ = landing.report;
  control_.learn(last_report_);
  if (!accepted) return false;
  const double target = setup_.whole.stop.relative_density.value_or(full_density);
  if (!(landing.density > target * (1.0 + density_tolerance))) return true;
  const auto try_again = [&](double shorter, Landing& tried) {
    ++totals_.fitting_attempts;
    return attempt(shorter, tried);
  };
  if (fit_density(try_again, {density_, target}, landing)) return true;
  last_report_.verdict = integrate::Verdict::moved_too_far;
  control_.learn(last_report_);
  return false;
}

void Simulation::accept(Landing&& landing) {
  const double hit = schedule_.next_hit(state_.time);
  state_ = std::move(landing.state);
  if (std::isfinite(hit) && std::abs(state_.time - hit) <= round_off * hit) state_.time = hit;
  density_ = landing.density;
  totals_.count_step(landing.report);
  last_report_ = landing.report;
  if (!(std::abs(density_ - last_change_.density) <= least_change * density_)) {
    last_change_ = {density_, state_.theta};
  }
}

// As if the step had not been tried: it is tried again, to the same bits, when the run goes on.
void Simulation::forget_step() {
  control_.go_on_from(before_step_.proposed_duration);
  totals_ = before_step_.totals;
}

std::optional<Ending> Simulation::advance() {
  for (;;) {
    const double duration = duration_to_try();
    if (is_frozen(duration)) {
      accept(waited(duration));
      return std::nullopt;
    }
    Landing landing;
    const bool is_made = take_step(duration, landing);
    if (std::exchange(is_step_given_up_, false)) {
      forget_step();
      if (const auto ended = reached_end()) return ended;
      continue;
    }
    if (is_made) {
      accept(std::move(landing));
      return std::nullopt;
    }
    ++totals_.rejected_steps;
    if (control_.is_exhausted() || last_report_.verdict == integrate::Verdict::unstable) return give_up();
    if (auto ended = reached_end()) return ended;
  }
}

Ending Simulation::give_up() const {
  if (last_report_.verdict == integrate::Verdict::unstable) {
    return {not_computed,
            fmt::format("explicit steps of {:.3g} s became unstable between {:.6g} s and {:.6g} s: {}; "
                        "allowed: method.time_step = \"auto\", or a shorter one",
                        last_report_.time_step(), state_.time, state_.time + last_report_.duration,
                        integrate::to_text(last_report_.verdict))};
  }
  return {not_computed,
          fmt::format("the step at {:.6g} s cannot be made, not even with {:.3g} s: {}", state_.time,
                      last_report_.duration, integrate::to_text(last_report_.verdict))};
}

observe::Row Simulation::observed_row() const {
  const NeckArrays necks = necks_of(setup_.settings.law, state_, setup_.furnace.delta_b(state_.time));
  observe::Row row = observe::observe_row(setup_.reference, state_, necks.view());
  row.push_back({"time_step [s]", totals_.steps > 0 ? totals_.last_duration : observe::no_value});
  row.push_back({"steps", static_cast<double>(totals_.steps)});
  row.push_back({"newton_iterations", static_cast<double>(totals_.newton_iterations)});
  row.push_back({"solver_iterations", static_cast<double>(totals_.solver_iterations)});
  return row;
}

void Simulation::write_row(std::span<RunListener* const> listeners) {
  clock_.enter(Stage::observe);
  row_ = observed_row();
  row_step_ = totals_.steps;
  clock_.enter(Stage::output);
  const RowView view{state_, row_, setup_.furnace.delta_b(state_.time)};
  for (RunListener* listener : listeners) listener->row_written(view);
}

void Simulation::tell_checkpoint(std::span<RunListener* const> listeners) const {
  const Progress now = progress();
  for (RunListener* listener : listeners) listener->checkpoint_due({state_, now});
}

// The row of an early end is not one that an uninterrupted run would have, so the checkpoint comes before it.
void Simulation::stop(const Ending& ending, std::span<RunListener* const> listeners) {
  clock_.enter(Stage::output);
  if (ending.code != 0) tell_checkpoint(listeners);
  if (row_step_ != totals_.steps) write_row(listeners);
  if (ending.code == 0) tell_checkpoint(listeners);
  clock_.enter(Stage::output);
  EndView view{ending, row_, totals_, clock_};
  const bool unsolved =
      ending.code == not_computed && (last_report_.verdict == integrate::Verdict::not_solved ||
                                      last_report_.verdict == integrate::Verdict::inconsistent);
  if (unsolved) view.failed = stepper_->failed();
  for (RunListener* listener : listeners) listener->finished(view);
}

std::optional<Ending> Simulation::start(std::span<RunListener* const> listeners) {
  clock_.enter(Stage::output);
  for (RunListener* listener : listeners) listener->started(setup_);
  if (is_resumed_) {
    row_ = observed_row();
    for (RunListener* listener : listeners) listener->resumed({state_, row_, totals_});
  } else {
    write_row(listeners);
  }
  watch_.lap(totals_.steps);  // an end takes no longer
  std::optional<Ending> ending = reached_end();
  if (ending) stop(*ending, listeners);
  return ending;
}

std::optional<Ending> Simulation::step(std::span<RunListener* const> listeners) {
  clock_.enter(Stage::step);
  listeners_ = listeners;
  std::optional<Ending> ending = advance();
  listeners_ = {};
  clock_.enter(Stage::output);
  if (!ending) {
    const StepView view{state_, last_report_, totals_, density_};
    for (RunListener* listener : listeners) listener->step_made(view);
    if (schedule_.is_due({state_.time, density_, totals_.steps})) write_row(listeners);
    watch_.lap(totals_.steps);
    if (watch_.takes_checkpoint()) tell_checkpoint(listeners);
    ending = reached_end();
  }
  if (ending) stop(*ending, listeners);
  return ending;
}

Ending Simulation::run(std::span<RunListener* const> listeners) {
  std::optional<Ending> ending = start(listeners);
  while (!ending) ending = step(listeners);
  return *ending;
}

}  // namespace frit::run
