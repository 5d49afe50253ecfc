// The necks between particles, as a structure of arrays sorted by (i, j, image), with their history.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "state/cell.hpp"

namespace frit {

struct Contacts {
  std::vector<std::int32_t> i, j;           // particles (internal rows), i <= j
  std::vector<Image> image;                 // which copy of j touches i
  std::vector<double> neck_radius_squared;  // [m^2], state function of the overlap, not capped; at `overlap`
  std::vector<double> overlap;              // [m], R_i + R_j - distance at which neck_radius_squared holds
  std::vector<double> birth_neck_radius;    // [m]
  std::vector<double> birth_time;           // [s]; 0 for the contacts of the packing
  std::vector<double> equilibrium_force;    // [N], the multiplier l of the equilibrium, in [0, attraction]
  std::vector<double> normal_force;         // [N], mean over the last step, > 0 repels
  std::vector<double> approach_velocity;    // [m/s], mean over the last step, > 0 approaches
  std::vector<Vec3> sliding_velocity;       // [m/s], mean over the last step
  std::vector<double> rolling_path;   // [rad], since birth: integral of the relative spin across the normal
  std::vector<double> twisting_path;  // [rad], since birth: the same along the normal
  std::vector<double> sliding_path;   // [m], since birth: integral of the sliding speed

  std::size_t size() const { return i.size(); }
  void resize(std::size_t count) {
    i.resize(count);
    j.resize(count);
    image.resize(count);
    neck_radius_squared.resize(count);
    overlap.resize(count);
    birth_neck_radius.resize(count);
    birth_time.resize(count);
    equilibrium_force.resize(count);
    normal_force.resize(count);
    approach_velocity.resize(count);
    sliding_velocity.resize(count, Vec3::Zero());
    rolling_path.resize(count);
    twisting_path.resize(count);
    sliding_path.resize(count);
  }
  void reserve(std::size_t count) {
    i.reserve(count);
    j.reserve(count);
    image.reserve(count);
    neck_radius_squared.reserve(count);
    overlap.reserve(count);
    birth_neck_radius.reserve(count);
    birth_time.reserve(count);
    equilibrium_force.reserve(count);
    normal_force.reserve(count);
    approach_velocity.reserve(count);
    sliding_velocity.reserve(count);
    rolling_path.reserve(count);
    twisting_path.reserve(count);
    sliding_path.reserve(count);
  }
};

// Faces that overlap without a neck between them (a broken neck): touch again at overlap_when_parted.
struct Cracks {
  std::vector<std::int32_t> i, j;
  std::vector<Image> image;
  std::vector<double> overlap_when_parted;  // [m]

  std::size_t size() const { return i.size(); }
  void add(std::int32_t first, std::int32_t second, const Image& shift, double overlap) {
    i.push_back(first);
    j.push_back(second);
    image.push_back(shift);
    overlap_when_parted.push_back(overlap);
  }
};

}  // namespace frit
