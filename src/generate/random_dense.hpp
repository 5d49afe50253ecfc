// Random dense packings with a network of real contacts, at a density of choice (docs/packings.md).
#pragma once

#include <cstdint>
#include <functional>

#include "generate/lattice.hpp"
#include "generate/packing.hpp"

namespace frit::generate {

struct RandomDenseOptions {
  std::int64_t count = 4000;       // spheres, at least 1
  double mean_radius = 5e-6;       // [m], of the spheres that are handed out
  double relative_spread = 0.0;    // standard deviation / mean of the log-normal radii, 0 <= spread < 1
  double relative_density = 0.64;  // sphere volume / volume, 0.60 to 0.66
  std::uint64_t seed = 1;
  Boundary boundary = Boundary::periodic;
  std::function<bool()> abandon = {};  // asked often; true: make_random_dense throws Abandoned
};

// Periodic: a cube whose density is met to round-off. Free: the `count` spheres nearest to the centre of a
// larger such cube, their centre of mass at the origin. Contacts overlap slightly. The same options give the
// same bits for any number of threads. Throws InputError with every fault of the options.
Packing make_random_dense(const RandomDenseOptions& options);

}  // namespace frit::generate
