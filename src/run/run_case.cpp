#include "run/run_case.hpp"

#include <utility>

namespace frit::run {

Ending run_case(const config::Case& whole, const std::vector<RunListener*>& listeners, Interrupt interrupt) {
  StageClock clock;
  const Setup setup = make_setup(whole);
  return Simulation(setup, clock, std::move(interrupt)).run(listeners);
}

}  // namespace frit::run
