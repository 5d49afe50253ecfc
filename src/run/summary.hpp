// A run in one object: what summary.json holds (docs/formats.md).
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "run/listener.hpp"
#include "run/setup.hpp"

namespace frit::run {

nlohmann::json summary_of(const Setup& setup, const EndView& end);

// Columns by name; no value is null.
nlohmann::json json_of(const observe::Row& row);

}  // namespace frit::run
