// What may be asked of a run from outside while it goes on. None of it changes a result.
#pragma once

#include <functional>
#include <limits>

namespace frit::run {

struct Requests {
  // The signal that asks the run to end; 0: none. Asked between steps and, often, within them: a step under
  // way is given up, and the run ends with the state before it.
  std::function<int()> interrupt = {};
  std::function<bool()> asks_checkpoint = {};  // whether a checkpoint has been asked for since the last call
  std::function<double()> wall_seconds = {};   // the clock; unset: since the simulation was made [s]
  double wall_limit = std::numeric_limits<double>::infinity();  // [s] by that clock, ends the run before it
};

}  // namespace frit::run
