// The necks between particles, as a structure of arrays sorted by (i, j, image), with their history.
#pragma once

#include <cstddef>
#include <cstdint>
#include <type_traits>
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

  // visit(name, pointer to the array) for all of the above; what treats them alike names none of them.
  template <class Visit>
  static void for_each_array(const Visit& visit) {
    visit("i", &Contacts::i);
    visit("j", &Contacts::j);
    visit("image", &Contacts::image);
    visit("neck_radius_squared", &Contacts::neck_radius_squared);
    visit("overlap", &Contacts::overlap);
    visit("birth_neck_radius", &Contacts::birth_neck_radius);
    visit("birth_time", &Contacts::birth_time);
    visit("equilibrium_force", &Contacts::equilibrium_force);
    visit("normal_force", &Contacts::normal_force);
    visit("approach_velocity", &Contacts::approach_velocity);
    visit("sliding_velocity", &Contacts::sliding_velocity);
    visit("rolling_path", &Contacts::rolling_path);
    visit("twisting_path", &Contacts::twisting_path);
    visit("sliding_path", &Contacts::sliding_path);
  }

  // What an array holds for a new contact.
  template <class Value>
  static Value zero_of(const std::vector<Value>& /*array*/) {
    if constexpr (std::is_same_v<Value, Vec3>) {
      return Vec3::Zero();
    } else {
      return {};
    }
  }

  // New contacts are all zeros.
  void resize(std::size_t count) {
    for_each_array([&](const char*, auto array) { (this->*array).resize(count, zero_of(this->*array)); });
  }
  void reserve(std::size_t count) {
    for_each_array([&](const char*, auto array) { (this->*array).reserve(count); });
  }
};
static_assert(sizeof(Contacts) == 14 * sizeof(std::vector<double>), "for_each_array names all of them");

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
