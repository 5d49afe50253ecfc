// What several keys of a case must fulfil together, and the defaults that depend on other keys.
#pragma once

#include "config/case.hpp"
#include "config/faults.hpp"

namespace frit::config {

// Adds a fault for everything that does not go together.
void check_case(const Case& whole, const Given& given, Faults& faults);

// Fills in what follows from other keys; for a case without faults.
void resolve_case(Case& whole, const Given& given);

}  // namespace frit::config
