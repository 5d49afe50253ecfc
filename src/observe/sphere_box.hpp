// How much of a sphere lies in a box with faces along the axes.
#pragma once

#include "core/vec.hpp"

namespace frit::observe {

struct Box {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();  // [m], corners

  double volume() const { return (high - low).prod(); }
  bool contains(const Vec3& point) const {
    return (point.array() >= low.array()).all() && (point.array() <= high.array()).all();
  }
};

// Volume [m^3] of the sphere within the box, low <= high. Whole spheres, half spaces and blocks inside the
// sphere are exact; the rest is integrated, with an error below 1e-7 of the sphere's volume.
double sphere_volume_in_box(const Vec3& centre, double radius, const Box& box);

}  // namespace frit::observe
