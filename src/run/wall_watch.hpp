// When the wall clock asks for a checkpoint or for the end of a run.
#pragma once

#include <cstdint>

#include "run/requests.hpp"

namespace frit::run {

inline constexpr double checkpoint_interval = 300.0;  // [s]

class WallWatch {
 public:
  // Checkpoints every so many steps; 0: every checkpoint_interval.
  WallWatch(Requests requests, std::int64_t every_steps);

  // After a step with its outputs; `steps` are those made by now.
  void lap(std::int64_t steps);

  // Whether a checkpoint is due or has been asked for; it counts as taken.
  bool takes_checkpoint();

  // Within a step: whether a checkpoint has been asked for; it counts as taken.
  bool takes_checkpoint_at_once();

  // The signal that asks for the end, or 0.
  int signal() const { return requests_.interrupt ? requests_.interrupt() : 0; }

  // Whether another step, with the end of the run after it, could pass the limit.
  bool runs_out() const;

  // Within a step: whether what is left of the limit is needed for the end of the run.
  bool is_out() const;

 private:
  bool is_asked();

  Requests requests_;
  std::int64_t every_steps_, steps_ = 0, checkpoint_steps_ = 0;
  double last_lap_, longest_lap_ = 0.0, last_checkpoint_;  // [s]
};

}  // namespace frit::run
