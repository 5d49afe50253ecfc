#include "observe/union_volume.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/constants.hpp"
#include "core/parallel.hpp"
#include "observe/neighbour_lists.hpp"

namespace frit::observe {
namespace {

constexpr std::size_t direction_count = 512;
constexpr std::size_t lanes = 8;  // partial sums, so that the order of summing is the same on every machine
using PerDirection = std::array<double, direction_count>;

struct Directions {
  PerDirection x, y, z;

  double along(const Vec3& vector, std::size_t n) const {
    return vector.x() * x[n] + vector.y() * y[n] + vector.z() * z[n];
  }
};

// A spiral of points of equal area on the unit sphere (Fibonacci lattice).
Directions spiral_directions() {
  Directions directions;
  const double turn = pi * (3.0 - std::sqrt(5.0));
  for (std::size_t n = 0; n < direction_count; ++n) {
    const auto index = static_cast<double>(n);
    const double z = 1.0 - (2.0 * index + 1.0) / static_cast<double>(direction_count);
    const double ring = std::sqrt(1.0 - z * z);
    directions.x[n] = ring * std::cos(turn * index);
    directions.y[n] = ring * std::sin(turn * index);
    directions.z[n] = z;
  }
  return directions;
}

// The half space y . normal <= reach that the power diagram leaves to a sphere; lengths in its radius.
struct Cut {
  Vec3 normal;   // unit, towards the neighbour
  double reach;  // distance of the radical plane; negative when the centre is on the neighbour's side
};

// cos of the half-angle of the cap is `reach`; two caps are apart when their directions differ by more than
// the sum of their half-angles.
bool caps_are_apart(const Cut& one, const Cut& other) {
  if (one.reach <= 0.0 || other.reach <= 0.0) return false;
  const double sines = std::sqrt((1.0 - one.reach * one.reach) * (1.0 - other.reach * other.reach));
  return one.normal.dot(other.normal) <= one.reach * other.reach - sines;
}

// Of the unit sphere.
double cap_volume(const Cut& cut) {
  const double height = 1.0 - cut.reach;
  return pi * height * height * (3.0 - height) / 3.0;
}

template <class Choice>
void keep(const PerDirection& found, PerDirection& kept, Choice&& choose) {
  for (std::size_t n = 0; n < direction_count; ++n) kept[n] = choose(kept[n], found[n]);
}

// Volume of the unit ball within all cuts. Along a direction u the ball's ray is left from 1/inner to
// 1/outer, where inverse distances to the planes are u . normal / reach.
double integrate_cut_ball(const std::vector<Cut>& cuts, const Directions& directions) {
  constexpr double at_centre = 1e-12;
  PerDirection outer_inverse, inner_inverse;
  outer_inverse.fill(1.0);
  inner_inverse.fill(std::numeric_limits<double>::infinity());
  for (const Cut& cut : cuts) {
    const Vec3 scaled = cut.normal / std::copysign(std::max(std::abs(cut.reach), at_centre), cut.reach);
    PerDirection inverse;
    for (std::size_t n = 0; n < direction_count; ++n) inverse[n] = directions.along(scaled, n);
    if (cut.reach >= 0.0) {
      keep(inverse, outer_inverse, [](double now, double farther) { return std::max(now, farther); });
    } else {
      keep(inverse, inner_inverse, [](double now, double nearer) { return std::min(now, nearer); });
    }
  }
  std::array<double, lanes> sums{};
  for (std::size_t n = 0; n < direction_count; n += lanes) {
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      const double outer = 1.0 / outer_inverse[n + lane];
      const double inner = 1.0 / std::max(inner_inverse[n + lane], 0.0);
      sums[lane] += std::max(outer * outer * outer - inner * inner * inner, 0.0);
    }
  }
  double sum = 0.0;
  for (const double part : sums) sum += part;
  return 4.0 * pi / 3.0 * sum / static_cast<double>(direction_count);
}

// A rotation for each particle, evenly spread over all rotations: the errors of the directions then cancel
// over the particles, even in a lattice where all have the same neighbours.
Mat3 turn_for(std::int64_t id) {
  const auto spread = [&](double step) {
    const double multiple = static_cast<double>(id + 1) * step;
    return multiple - std::floor(multiple);
  };
  // Powers of 1/1.2207...: the root that makes multiples in three dimensions fill the unit cube evenly.
  const double share = spread(0.8191725133961645);
  const double first = 2.0 * pi * spread(0.6710436067037893), second = 2.0 * pi * spread(0.5497004779019703);
  const double a = std::sqrt(1.0 - share), b = std::sqrt(share);
  return Quat(a * std::sin(first), a * std::cos(first), b * std::sin(second), b * std::cos(second))
      .toRotationMatrix();
}

// The cuts of a particle that reach into its sphere; replaces what `cuts` holds.
void find_cuts(const State& state, const NeighbourLists& lists, std::size_t row, std::vector<Cut>& cuts) {
  cuts.clear();
  const Particles& particles = state.particles;
  const double radius = particles.radius[row];
  for (const Neighbour& neighbour : lists.of(row)) {
    const Vec3 arm =
        state.cell.separation(particles.position[row], particles.position[neighbour.row], neighbour.image);
    const double distance = arm.norm();
    if (distance == 0.0) continue;
    const double other = particles.radius[neighbour.row];
    const double reach = 0.5 * (distance + (radius - other) * (radius + other) / distance) / radius;
    if (reach < 1.0) cuts.push_back({arm / distance, reach});
  }
}

// The same; a cap that touches no other is simply taken off.
double cut_ball_volume(const std::vector<Cut>& cuts, const Directions& directions, std::int64_t id) {
  const auto touches_another = [&](const Cut& cut) {
    if (cut.reach <= 0.0) return true;
    return std::any_of(cuts.begin(), cuts.end(),
                       [&](const Cut& other) { return &other != &cut && !caps_are_apart(cut, other); });
  };
  std::vector<Cut> crowded;
  double single_caps = 0.0;
  for (const Cut& cut : cuts) {
    if (touches_another(cut)) {
      crowded.push_back(cut);
    } else {
      single_caps += cap_volume(cut);
    }
  }
  if (crowded.empty()) return 4.0 / 3.0 * pi - single_caps;
  const Mat3 turn = turn_for(id);
  for (Cut& cut : crowded) cut.normal = turn * cut.normal;
  return std::max(integrate_cut_ball(crowded, directions) - single_caps, 0.0);
}

// Of each particle, with whom it may overlap: by a neck, or across a crack where a neck broke.
NeighbourLists overlap_lists(const State& state) {
  std::vector<std::int32_t> i = state.contacts.i, j = state.contacts.j;
  std::vector<Image> image = state.contacts.image;
  i.insert(i.end(), state.cracks.i.begin(), state.cracks.i.end());
  j.insert(j.end(), state.cracks.j.begin(), state.cracks.j.end());
  image.insert(image.end(), state.cracks.image.begin(), state.cracks.image.end());
  return {state.particles.size(), {i, j, image}};
}

}  // namespace

std::vector<double> union_volumes(const State& state) {
  static const Directions directions = spiral_directions();
  const Particles& particles = state.particles;
  const NeighbourLists lists = overlap_lists(state);
  std::vector<double> volumes(particles.size());
  parallel_blocks(particles.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Cut> cuts;
    for (std::size_t row = begin; row < end; ++row) {
      find_cuts(state, lists, row, cuts);
      const double radius = particles.radius[row];
      volumes[row] = cut_ball_volume(cuts, directions, particles.id[row]) * radius * radius * radius;
    }
  });
  return volumes;
}

}  // namespace frit::observe
