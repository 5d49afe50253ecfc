// What a packing must fulfil before a run can start, beyond what its file shows.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "config/case.hpp"
#include "generate/packing.hpp"
#include "observe/reference.hpp"
#include "run/translate.hpp"
#include "state/state.hpp"

namespace frit::run {

using FaultTexts = std::vector<std::string>;

// Faults of spheres and cell: a cell smaller than a sphere, spheres inside each other, more solid than room.
void check_spheres(const config::Case& whole, const generate::Packing& packing, FaultTexts& faults);

// Faults of the first contacts: none where nothing can ever touch, or necks between spheres far apart.
void check_contacts(const config::Case& whole, const State& state, FaultTexts& faults);

// Faults of the stop: a density that the run cannot measure or starts beyond.
void check_stop(const config::Case& whole, const observe::Reference& reference, double density,
                FaultTexts& faults);

// What is allowed but worth knowing.
std::vector<std::string> find_warnings(const config::Case& whole, const State& state, double density);

// That the furnace passes the melting temperature before the run's stop.time, if it does.
std::optional<std::string> warn_of_melting(const config::Case& whole, const Heating& heating);

// Explicit dynamics: that the multiplied mass spoils young necks, if it does at this Delta_b [m^5/(N s)].
std::optional<std::string> warn_of_inertia(const config::Case& whole, const State& state, double delta_b);

}  // namespace frit::run
