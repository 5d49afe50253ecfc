// A case from its setup to its last state, in one call.
#pragma once

#include <vector>

#include "config/case.hpp"
#include "run/listener.hpp"
#include "run/simulation.hpp"

namespace frit::run {

// Runs the case and tells the listeners, in their order. Throws InputError before any listener is told
// anything, and whatever a listener throws.
Ending run_case(const config::Case& whole, const std::vector<RunListener*>& listeners,
                Interrupt interrupt = {});

}  // namespace frit::run
