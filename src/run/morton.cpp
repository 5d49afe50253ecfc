#include "run/morton.hpp"

#include <algorithm>
#include <array>
#include <tuple>

namespace frit::run {
namespace {

constexpr int bits_per_axis = 21;

// Puts two zero bits between any two of the lowest 21 bits.
std::uint64_t spread_bits(std::uint64_t bits) {
  bits = (bits | bits << 32) & 0x001F00000000FFFFu;
  bits = (bits | bits << 16) & 0x001F0000FF0000FFu;
  bits = (bits | bits << 8) & 0x100F00F00F00F00Fu;
  bits = (bits | bits << 4) & 0x10C30C30C30C30C3u;
  return (bits | bits << 2) & 0x1249249249249249u;
}

struct Bounds {
  Vec3 low, high;
};

Bounds bounds_of(const std::vector<Vec3>& positions) {
  Bounds bounds{positions.front(), positions.front()};
  for (const Vec3& x : positions) {
    bounds.low = bounds.low.cwiseMin(x);
    bounds.high = bounds.high.cwiseMax(x);
  }
  return bounds;
}

std::uint64_t morton_code(const Vec3& x, const Bounds& bounds) {
  // One scale for all axes keeps the curve's cubes cubes.
  const double extent = (bounds.high - bounds.low).maxCoeff();
  constexpr double last_cell = (1 << bits_per_axis) - 1;
  std::uint64_t code = 0;
  for (int axis = 0; axis < 3; ++axis) {
    const double share = extent > 0.0 ? (x[axis] - bounds.low[axis]) / extent : 0.0;
    code |= spread_bits(static_cast<std::uint64_t>(share * last_cell)) << axis;
  }
  return code;
}

template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::int32_t>& order) {
  std::vector<Value> result;
  result.reserve(order.size());
  for (const std::int32_t row : order) result.push_back(values[static_cast<std::size_t>(row)]);
  return result;
}

}  // namespace

std::vector<std::int32_t> morton_order(const Particles& particles) {
  if (particles.size() == 0) return {};
  const Bounds bounds = bounds_of(particles.position);
  using Place = std::tuple<std::uint64_t, std::array<double, 3>, std::int32_t>;
  std::vector<Place> places(particles.size());
  for (std::size_t n = 0; n < places.size(); ++n) {
    const Vec3& x = particles.position[n];
    places[n] = {morton_code(x, bounds), {x.x(), x.y(), x.z()}, static_cast<std::int32_t>(n)};
  }
  std::sort(places.begin(), places.end());
  std::vector<std::int32_t> order(places.size());
  for (std::size_t n = 0; n < order.size(); ++n) order[n] = std::get<2>(places[n]);
  return order;
}

Particles reordered(const Particles& particles, const std::vector<std::int32_t>& order) {
  Particles result;
  result.id = picked(particles.id, order);
  result.position = picked(particles.position, order);
  result.radius = picked(particles.radius, order);
  result.mass = picked(particles.mass, order);
  result.velocity = picked(particles.velocity, order);
  result.spin = picked(particles.spin, order);
  result.orientation = picked(particles.orientation, order);
  result.force = picked(particles.force, order);
  result.fixed = picked(particles.fixed, order);
  return result;
}

}  // namespace frit::run
