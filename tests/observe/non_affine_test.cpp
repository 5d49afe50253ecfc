#include "observe/non_affine.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "observe/samples.hpp"

namespace frit::observe {
namespace {

using samples::make_lattice;

void set_velocities(State& state, const Mat3& gradient, const Vec3& drift) {
  for (std::size_t row = 0; row < state.particles.size(); ++row) {
    state.particles.velocity[row] = gradient * state.particles.position[row] + drift;
  }
}

TEST(NonAffineShare, OfAnAffineFieldIsZero) {
  Mat3 gradient;
  gradient << -1.0, 0.4, 0.0, 0.3, -2.0, 0.1, 0.2, -0.5, -1.0;
  State body = make_lattice({.jitter = 0.1});
  set_velocities(body, gradient, Vec3::Constant(1e-4));
  EXPECT_LT(non_affine_share(body), 1e-12);

  State cell = make_lattice({.jitter = 0.1, .periodic = true});
  cell.cell_rate = Vec3(-1.0, -2.0, 0.5);
  set_velocities(cell, cell.cell_rate.asDiagonal(), Vec3::Constant(1e-4));
  EXPECT_LT(non_affine_share(cell), 1e-11);
}

TEST(NonAffineShare, OfAPeriodicCellAtRestIsOne) {
  State state = make_lattice({.periodic = true});
  samples::Random random(2);
  for (Vec3& velocity : state.particles.velocity) velocity = random.vector(1e-9);
  EXPECT_DOUBLE_EQ(non_affine_share(state), 1.0);
}

TEST(NonAffineShare, IsThatOfAKnownFluctuation) {
  State state = make_lattice({.edge = 2, .periodic = true});
  const double spacing = 1.9 * samples::radius;
  state.cell_rate = Vec3(-2.0, 0.0, 0.0);  // velocities of the layers: a rate of +-spacing about the mean
  set_velocities(state, state.cell_rate.asDiagonal(), Vec3::Zero());
  for (std::size_t row = 0; row < 8; ++row)
    state.particles.velocity[row].z() += (row % 2 == 0 ? 1 : -1) * spacing;
  EXPECT_NEAR(non_affine_share(state), std::sqrt(0.5), 1e-13);
  const auto rest = non_affine_velocities(state);
  EXPECT_NEAR(rest[0].z(), spacing, 1e-18);
  EXPECT_NEAR(rest[0].x(), 0.0, 1e-18);
}

TEST(NonAffineShare, DoesNotDependOnDriftOrOrigin) {
  State state = make_lattice({.jitter = 0.1, .periodic = true});
  state.cell_rate = Vec3(-1.0, -1.5, -2.0);
  set_velocities(state, state.cell_rate.asDiagonal(), Vec3::Zero());
  samples::Random random(12);
  for (Vec3& velocity : state.particles.velocity) velocity += random.vector(1e-5);
  const double share = non_affine_share(state);
  const Vec3 shift(1e-4, 2e-4, -1e-4);
  for (std::size_t row = 0; row < state.particles.size(); ++row) {
    state.particles.position[row] += shift;
    state.particles.velocity[row] += state.cell_rate.cwiseProduct(shift) + Vec3::Constant(3e-5);
  }
  EXPECT_GT(share, 0.1);
  EXPECT_NEAR(non_affine_share(state), share, 1e-12);
}

TEST(NonAffineShare, HasNoValueAtRest) {
  EXPECT_TRUE(std::isnan(non_affine_share(make_lattice({.periodic = true}))));
}

}  // namespace
}  // namespace frit::observe
