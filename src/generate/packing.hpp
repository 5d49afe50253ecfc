// What generators hand out: spheres and the space they are in.
#pragma once

#include "state/cell.hpp"
#include "state/particles.hpp"

namespace frit::generate {

struct Packing {
  Particles particles;  // at rest, without mass: the material is not known here
  Cell cell;
};

}  // namespace frit::generate
