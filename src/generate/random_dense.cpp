#include "generate/random_dense.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "generate/bonds.hpp"
#include "generate/random.hpp"
#include "generate/soft_spheres.hpp"

namespace frit::generate {
namespace {

// Streams of random numbers: those of one use never repeat those of another.
constexpr std::uint64_t position_stream = 0, radius_stream = 1;

// docs/packings.md says how these were found.
constexpr double rigid_coordination = 6.0;  // below it, spheres are not jammed by repulsion alone
constexpr double rest_ratio = 0.01;         // overlap / R of an unloaded bond
constexpr int bonding_rounds = 4;
constexpr RelaxOptions push_apart = {.force_tolerance = 0.05, .overlap_tolerance = 1e-3, .most_steps = 1000};
constexpr RelaxOptions pull_together = {.force_tolerance = 0.03, .most_steps = 500};
// Spheres of the cube a ball is cut from, per sphere of the ball (6/pi for the ball that fills the cube), and
// the least: a smaller cube would let a small ball see its own images.
constexpr double cube_per_ball = 1.15 * 6.0 / pi;
constexpr std::int64_t smallest_cube = 300;

void check(const RandomDenseOptions& options) {
  std::vector<std::string> faults;
  const auto need = [&](bool sound, const char* key, const auto& value, const char* allowed) {
    if (!sound) faults.push_back(fmt::format("{}: {}; allowed is {}", key, value, allowed));
  };
  const double radius = options.mean_radius, spread = options.relative_spread,
               density = options.relative_density;
  need(options.count >= 1 && options.count <= 100'000'000, "count", options.count, "1 to 100000000");
  need(radius > 0.0 && std::isfinite(radius), "radius", radius, "a positive length [m]");
  need(spread >= 0.0 && spread < 1.0, "radius_spread", spread, "0 up to, not including, 1");
  need(density >= 0.60 && density <= 0.66, "relative_density", density,
       "0.60 to 0.66 (looser powders are made by other generators)");
  if (!faults.empty()) throw InputError(faults);
}

void scale_to_mean_one(std::vector<double>& radii) {
  const double mean = std::accumulate(radii.begin(), radii.end(), 0.0) / static_cast<double>(radii.size());
  for (double& r : radii) r /= mean;
}

// Log-normal with the wanted standard deviation / mean: the logarithm has the variance ln(1 + spread^2).
std::vector<double> draw_radii(std::size_t count, double relative_spread, std::uint64_t seed) {
  const RandomStream random(seed, radius_stream);
  const double sigma = std::sqrt(std::log1p(relative_spread * relative_spread));
  std::vector<double> radii(count);
  for (std::size_t i = 0; i < count; ++i) radii[i] = std::exp(sigma * random.normal(i));
  scale_to_mean_one(radii);
  return radii;
}

std::vector<Vec3> draw_positions(std::size_t count, std::uint64_t seed) {
  const RandomStream random(seed, position_stream);
  std::vector<Vec3> positions(count);
  for (std::size_t i = 0; i < count; ++i) {
    positions[i] = {random.uniform(3 * i), random.uniform(3 * i + 1), random.uniform(3 * i + 2)};
  }
  return positions;
}

SoftSpheres make_network(std::size_t count, const RandomDenseOptions& options) {
  SoftSpheres spheres(draw_positions(count, options.seed),
                      draw_radii(count, options.relative_spread, options.seed), options.relative_density);
  spheres.abandon_when(options.abandon);
  const RelaxReport pushed = spheres.relax(push_apart);
  if (pushed.coordination >= rigid_coordination) return spheres;
  for (int round = 0; round < bonding_rounds; ++round) {
    spheres.bond(choose_bonds(spheres, {}), rest_ratio);
    spheres.relax(pull_together);
  }
  return spheres;
}

// Unit: mean radius. Positions inside the cell.
Packing to_packing(const SoftSpheres& spheres) {
  Packing packing{{}, spheres.cell()};
  for (std::size_t i = 0; i < spheres.radii().size(); ++i) {
    Vec3 x = spheres.positions()[i];
    for (int axis = 0; axis < 3; ++axis)
      x[axis] -= std::floor(x[axis] / packing.cell.size[axis]) * packing.cell.size[axis];
    packing.particles.add(x, spheres.radii()[i]);
  }
  return packing;
}

Packing cut_ball(const Packing& cube, std::size_t count) {
  const Vec3 centre = 0.5 * cube.cell.size;
  std::vector<std::pair<double, std::size_t>> nearest_first(cube.particles.size());
  for (std::size_t i = 0; i < nearest_first.size(); ++i) {
    nearest_first[i] = {(cube.particles.position[i] - centre).norm(), i};
  }
  std::sort(nearest_first.begin(), nearest_first.end());
  Packing ball;
  Vec3 moment = Vec3::Zero();
  double solid = 0.0;
  for (std::size_t n = 0; n < count; ++n) {
    const std::size_t i = nearest_first[n].second;
    const double r = cube.particles.radius[i];
    ball.particles.add(cube.particles.position[i], r);
    moment += r * r * r * cube.particles.position[i];
    solid += r * r * r;
  }
  for (Vec3& x : ball.particles.position) x -= moment / solid;
  return ball;
}

void scale_to_mean_radius(Packing& packing, double mean_radius) {
  auto& radii = packing.particles.radius;
  const double sum = std::accumulate(radii.begin(), radii.end(), 0.0);
  const double factor = mean_radius * static_cast<double>(radii.size()) / sum;
  for (double& r : radii) r *= factor;
  for (Vec3& x : packing.particles.position) x *= factor;
  packing.cell.size *= factor;
}

}  // namespace

Packing make_random_dense(const RandomDenseOptions& options) {
  check(options);
  const bool free = options.boundary == Boundary::free;
  const auto in_cube =
      static_cast<std::int64_t>(std::ceil(cube_per_ball * static_cast<double>(options.count)));
  const std::int64_t count = free ? std::max(smallest_cube, in_cube) : options.count;
  Packing packing = to_packing(make_network(static_cast<std::size_t>(count), options));
  if (free) packing = cut_ball(packing, static_cast<std::size_t>(options.count));
  scale_to_mean_radius(packing, options.mean_radius);
  return packing;
}

}  // namespace frit::generate
