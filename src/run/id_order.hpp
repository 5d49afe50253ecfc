// A state in the order of the stable ids: what is written out does not show the internal order.
#pragma once

#include "state/state.hpp"

namespace frit::run {

// The same state with particles in ascending order of their ids and contacts and cracks sorted accordingly
// (i <= j again; where a pair changes sides, its image and its sliding velocity change sign).
State in_id_order(const State& state);

}  // namespace frit::run
