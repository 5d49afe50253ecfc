// The domain: free space, or a periodic rectangular cell that may change its edge lengths.
#pragma once

#include <array>
#include <cstdint>

#include "core/vec.hpp"

namespace frit {

// Which periodic copy: how many cell edges the second particle of a pair is shifted by, in x, y and z.
using Image = std::array<std::int8_t, 3>;

struct Cell {
  bool periodic = false;
  Vec3 size = Vec3::Zero();  // [m], edge lengths; meaningless when not periodic

  double volume() const { return size.prod(); }

  Vec3 shift(const Image& image) const {
    return {image[0] * size.x(), image[1] * size.y(), image[2] * size.z()};
  }

  // Vector from x_i to the given image of x_j [m].
  Vec3 separation(const Vec3& x_i, const Vec3& x_j, const Image& image) const {
    return periodic ? Vec3(x_j + shift(image) - x_i) : Vec3(x_j - x_i);
  }
};

}  // namespace frit
