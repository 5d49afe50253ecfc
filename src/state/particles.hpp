// The particles: spheres with stable ids, as a structure of arrays. Internal order is free; ids are not.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"

namespace frit {

struct Particles {
  std::vector<std::int64_t> id;     // stable, 0-based row of the input; one per particle, as all below
  std::vector<Vec3> position;       // [m]
  std::vector<double> radius;       // [m]
  std::vector<double> mass;         // [kg], real density times volume
  std::vector<Vec3> velocity;       // [m/s], mean over the last step
  std::vector<Vec3> spin;           // [1/s], mean angular velocity over the last step
  std::vector<Quat> orientation;    // since the start of the run
  std::vector<Vec3> force;          // [N], external
  std::vector<std::uint8_t> fixed;  // 1: neither moves nor spins

  std::size_t size() const { return position.size(); }

  // A particle at rest, unloaded and unturned; its id is its row.
  void add(const Vec3& x, double r, double m = 0.0) {
    id.push_back(static_cast<std::int64_t>(size()));
    position.push_back(x);
    radius.push_back(r);
    mass.push_back(m);
    velocity.emplace_back(Vec3::Zero());
    spin.emplace_back(Vec3::Zero());
    orientation.push_back(Quat::Identity());
    force.emplace_back(Vec3::Zero());
    fixed.push_back(0);
  }
};

}  // namespace frit
