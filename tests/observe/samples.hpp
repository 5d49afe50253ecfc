// States for the tests: lattices and random clouds at the scale of a real powder, and what can be done to
// them.
#pragma once

#include <cmath>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include "state/state.hpp"

namespace frit::observe::samples {

inline constexpr double radius = 5e-6;  // [m]

// A seeded generator that gives the same numbers everywhere (SplitMix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t integer() {
    std::uint64_t mixed = (state_ += 0x9e3779b97f4a7c15u);
    mixed = (mixed ^ (mixed >> 30)) * 0xbf58476d1ce4e5b9u;
    mixed = (mixed ^ (mixed >> 27)) * 0x94d049bb133111ebu;
    return mixed ^ (mixed >> 31);
  }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(integer() >> 11) * 0x1p-53;
  }
  Vec3 vector(double size) {
    const double x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return {x, y, z};
  }

 private:
  std::uint64_t state_;
};

inline void add_contact(State& state, std::int32_t i, std::int32_t j, const Image& image = {0, 0, 0}) {
  Contacts& contacts = state.contacts;
  const std::size_t k = contacts.size();
  contacts.resize(k + 1);
  contacts.i[k] = i;
  contacts.j[k] = j;
  contacts.image[k] = image;
}

inline Image image_at(int x, int y, int z) {
  return {static_cast<std::int8_t>(x), static_cast<std::int8_t>(y), static_cast<std::int8_t>(z)};
}

// A contact for every overlapping pair and image, by looking at all of them.
inline void touch_all(State& state) {
  state.contacts = {};
  const Particles& particles = state.particles;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    for (std::size_t j = i; j < particles.size(); ++j) {
      for (int code = 0; code < 27; ++code) {
        const Image image = image_at(code / 9 - 1, code / 3 % 3 - 1, code % 3 - 1);
        const bool inside = image == Image{0, 0, 0};
        if ((!inside && !state.cell.periodic) || (i == j && code <= 13)) continue;
        const double distance =
            state.cell.separation(particles.position[i], particles.position[j], image).norm();
        const double overlap = particles.radius[i] + particles.radius[j] - distance;
        if (overlap > 0.0)
          add_contact(state, static_cast<std::int32_t>(i), static_cast<std::int32_t>(j), image);
      }
    }
  }
}

struct Lattice {
  int edge = 5;          // spheres along each edge
  double spacing = 1.9;  // in radii
  double jitter = 0.0;   // in radii
  bool periodic = false;
};

// A simple cubic lattice with all its contacts.
inline State make_lattice(const Lattice& lattice) {
  State state;
  Random random(7);
  for (int code = 0; code < lattice.edge * lattice.edge * lattice.edge; ++code) {
    const Vec3 place(code / (lattice.edge * lattice.edge), code / lattice.edge % lattice.edge,
                     code % lattice.edge);
    state.particles.add(radius * (lattice.spacing * place + random.vector(lattice.jitter)), radius);
  }
  state.cell.periodic = lattice.periodic;
  if (lattice.periodic) state.cell.size.setConstant(lattice.edge * lattice.spacing * radius);
  touch_all(state);
  return state;
}

// Every position x becomes map x + shift; a periodic cell follows (its map must be diagonal).
inline void move_affinely(State& state, const Mat3& map, const Vec3& shift = Vec3::Zero()) {
  for (Vec3& x : state.particles.position) x = map * x + shift;
  if (state.cell.periodic) state.cell.size = map * state.cell.size;
}

inline Mat3 some_rotation() {
  return Eigen::AngleAxisd(2.1, Vec3(0.3, -0.5, 0.8).normalized()).toRotationMatrix();
}

// The same state with another internal order; also the new row of each old one.
inline std::pair<State, std::vector<std::int32_t>> shuffle(const State& state, std::uint64_t seed) {
  Random random(seed);
  std::vector<std::int32_t> old_row(state.particles.size());
  std::iota(old_row.begin(), old_row.end(), 0);
  for (std::size_t row = old_row.size(); row > 1; --row)
    std::swap(old_row[row - 1], old_row[random.integer() % row]);
  State mixed = state;
  std::vector<std::int32_t> new_row(old_row.size());
  for (std::size_t row = 0; row < old_row.size(); ++row) {
    new_row[old_row[row]] = static_cast<std::int32_t>(row);
    mixed.particles.id[row] = state.particles.id[old_row[row]];
    mixed.particles.position[row] = state.particles.position[old_row[row]];
    mixed.particles.radius[row] = state.particles.radius[old_row[row]];
    mixed.particles.velocity[row] = state.particles.velocity[old_row[row]];
    mixed.particles.orientation[row] = state.particles.orientation[old_row[row]];
  }
  for (std::size_t k = 0; k < mixed.contacts.size(); ++k) {
    auto& i = mixed.contacts.i[k] = new_row[state.contacts.i[k]];
    auto& j = mixed.contacts.j[k] = new_row[state.contacts.j[k]];
    if (i <= j) continue;
    std::swap(i, j);
    const Image& image = state.contacts.image[k];
    mixed.contacts.image[k] = image_at(-image[0], -image[1], -image[2]);
  }
  return {mixed, new_row};
}

}  // namespace frit::observe::samples
