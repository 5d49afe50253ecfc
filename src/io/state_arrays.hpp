// A state, bit for bit, as entries of a map (docs/formats.md, "Checkpoint").
#pragma once

#include <string>

#include "io/cbor_map.hpp"
#include "state/state.hpp"

namespace frit::io {

// Names begin with `prefix`.
void put_state(CborMap& map, const std::string& prefix, const State& state);

// Throws InputError where entries are missing, of another length, or would lead astray: rows that are not
// there, ids that are not those of the rows, what is not finite.
State take_state(const CborMap& map, const std::string& prefix);

}  // namespace frit::io
