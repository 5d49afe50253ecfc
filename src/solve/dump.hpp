// A problem as bytes (CBOR, a binary form of JSON), to be written to a file and replayed later.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "solve/problem.hpp"

namespace frit::solve {

// The whole problem and a start for the solver, bit for bit (docs/formats.md, "Problem dump").
std::vector<std::uint8_t> dump(const Problem& problem, const Solution& start);

struct Dumped {
  Problem problem;
  Solution start;
};

// Throws InputError when the bytes are not a problem dump of a known version.
Dumped load_dump(std::span<const std::uint8_t> bytes);

}  // namespace frit::solve
