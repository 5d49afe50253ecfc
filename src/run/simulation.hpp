// The outer loop of a run: steps until a stop, outputs on the way, everyone told who listens.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "integrate/step_control.hpp"
#include "integrate/stepper.hpp"
#include "run/density_fit.hpp"
#include "run/listener.hpp"
#include "run/schedule.hpp"
#include "run/setup.hpp"
#include "run/wall_watch.hpp"

namespace frit::run {

// How a run ends at this time [s] and relative density, if these are what it was to reach.
std::optional<Ending> reached_stop(const config::Stop& stop, double time, double density);

class Simulation {
 public:
  // The setup must outlive the simulation.
  Simulation(const Setup& setup, StageClock& clock, Requests requests = {});

  Simulation(const Simulation&) = delete;  // its stepper asks it
  Simulation& operator=(const Simulation&) = delete;

  // Before run: from a checkpoint of the same setup (its stops may differ) instead of from the start.
  void go_on_from(State state, const Progress& progress);

  // Runs to the end and tells the listeners. Whatever they throw comes out.
  Ending run(std::span<RunListener* const> listeners);

  // The same in pieces, with the same listeners each time: `start` once, then `step` until there is an
  // ending, or `stop` to end at once.
  std::optional<Ending> start(std::span<RunListener* const> listeners);
  std::optional<Ending> step(std::span<RunListener* const> listeners);
  void stop(const Ending& ending, std::span<RunListener* const> listeners);

  const State& state() const { return state_; }
  const Totals& totals() const { return totals_; }
  double density() const { return density_; }  // relative; NaN: not known

 private:
  std::optional<Ending> reached_end() const;
  std::optional<Ending> why_nothing_moves() const;
  std::optional<Ending> advance();
  double duration_to_try() const;
  bool is_frozen(double duration) const;
  Landing waited(double duration) const;
  bool attempt(double duration, Landing& landing);
  bool take_step(double duration, Landing& landing);
  void accept(Landing&& landing);
  bool gives_up_step();
  void forget_step();
  Ending give_up() const;
  observe::Row observed_row() const;
  Progress progress() const;
  void write_row(std::span<RunListener* const> listeners);
  void tell_checkpoint(std::span<RunListener* const> listeners) const;

  // Where the density last changed by more than nothing.
  struct LastChange {
    double density, theta;
  };

  const Setup& setup_;
  StageClock& clock_;
  WallWatch watch_;
  std::unique_ptr<integrate::Stepper> stepper_;
  integrate::StepControl control_;
  Schedule schedule_;
  State state_;
  double density_;
  LastChange last_change_;
  Totals totals_;
  integrate::StepReport last_report_;
  Progress before_step_;  // what a checkpoint taken within the step holds
  bool is_step_given_up_ = false;
  std::span<RunListener* const> listeners_;  // while a step is under way
  observe::Row row_;
  bool is_resumed_ = false;
  std::int64_t row_step_ = -1;  // steps made when the last row was written
};

}  // namespace frit::run
