#include "observe/non_affine.hpp"

#include <cmath>
#include <numeric>

#include "observe/motion.hpp"
#include "observe/statistics.hpp"

namespace frit::observe {
namespace {

void remove_mean(std::vector<Vec3>& velocities) {
  if (velocities.empty()) return;
  const Vec3 sum = std::accumulate(velocities.begin(), velocities.end(), Vec3(Vec3::Zero()));
  const Vec3 mean = sum / static_cast<double>(velocities.size());
  for (Vec3& velocity : velocities) velocity -= mean;
}

double sum_of_squares(const std::vector<Vec3>& velocities) {
  double sum = 0.0;
  for (const Vec3& velocity : velocities) sum += velocity.squaredNorm();
  return sum;
}

}  // namespace

std::vector<Vec3> non_affine_velocities(const State& state) {
  const auto& position = state.particles.position;
  std::vector<Vec3> rest = state.particles.velocity;
  const Mat3 gradient = state.cell.periodic ? Mat3(state.cell_rate.asDiagonal())
                                            : fit_affine(position, state.particles.velocity).gradient;
  for (std::size_t row = 0; row < rest.size(); ++row) rest[row] -= gradient * position[row];
  remove_mean(rest);
  return rest;
}

double non_affine_share(const State& state) {
  std::vector<Vec3> velocity = state.particles.velocity;
  remove_mean(velocity);
  const double whole = sum_of_squares(velocity);
  return whole > 0.0 ? std::sqrt(sum_of_squares(non_affine_velocities(state)) / whole) : no_value;
}

}  // namespace frit::observe
