// What a run carries from step to step beside its state: enough to go on as if never interrupted.
#pragma once

#include <cstdint>

#include "run/totals.hpp"

namespace frit::run {

struct Progress {
  double density = 0.0;            // relative; NaN: not known
  double proposed_duration = 0.0;  // [s], of the next step
  std::int64_t output_level = 0;   // the schedule's memory
  double changed_density = 0.0;    // where the density last changed by more than nothing
  double changed_theta = 0.0;      // [m^5 s/(N s)]
  std::int64_t row_step = -1;      // steps made when the last row was written
  Totals totals;
};

}  // namespace frit::run
