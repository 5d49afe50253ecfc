#include "observe/particle_stress.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "observe/density.hpp"
#include "observe/samples.hpp"

namespace frit::observe {
namespace {

constexpr double R = samples::radius;
constexpr double volume = 4.0 / 3.0 * std::numbers::pi * R * R * R;

TEST(ParticleStress, OfASqueezedPairIsForceTimesArmOverVolume) {
  State state;
  state.particles.add(Vec3::Zero(), R);
  state.particles.add(Vec3(0.0, 0.0, 1.8 * R), R);
  samples::touch_all(state);
  state.contacts.normal_force[0] = 2e-4;  // repels
  const auto stresses = particle_stresses(state, {});
  for (const Mat3& stress : stresses) {
    EXPECT_NEAR(stress(2, 2), -2e-4 * 0.9 * R / volume, 1e-9 * 2e-4 * R / volume);
    EXPECT_EQ(stress(0, 0), 0.0);
  }
}

// In a cubic cell each neck along z carries stress times the face of a cube.
TEST(ParticleStress, OfALatticeUnderStressIsThatStress) {
  State state = samples::make_lattice({.edge = 3, .periodic = true});
  const double spacing = 1.9 * R, stress = 1e5;
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    if (state.contacts.image[k][2] != 0 || state.contacts.j[k] == state.contacts.i[k] + 1)
      state.contacts.normal_force[k] = -stress * spacing * spacing;
  }
  const Mat3 found =
      mean_stress(state, particle_stresses(state, {}), relative_density(take_reference(state), state));
  EXPECT_NEAR(found(2, 2), stress, 1e-9 * stress);
  EXPECT_NEAR(found(0, 0), 0.0, 1e-9 * stress);
}

TEST(ParticleStress, IsSharedByLeverArmsAndTurnsWithTheBody) {
  State state;
  state.particles.add(Vec3::Zero(), R);
  state.particles.add(Vec3(3.8 * R, 0.0, 0.0), 3.0 * R);
  samples::touch_all(state);
  state.contacts.normal_force[0] = 1e-4;
  state.contacts.sliding_velocity[0] = Vec3(0.0, 1e-9, 0.0);
  const std::vector<double> c_t{4e4};
  const auto flat = particle_stresses(state, {.sliding_resistance = c_t});
  EXPECT_NEAR(flat[0](0, 0), -1e-4 * 0.95 * R / volume, 1e-12 * 1e-4 * R / volume);
  EXPECT_NEAR(flat[1](0, 0), flat[0](0, 0) / 9.0, 1e-12 * flat[0].norm());  // arm 3, volume 27
  EXPECT_NEAR(flat[0](0, 1), -0.5 * 4e-5 * 0.95 * R / volume, 1e-12 * flat[0].norm());
  const Mat3 turn = samples::some_rotation();
  samples::move_affinely(state, turn);
  state.contacts.sliding_velocity[0] = turn * state.contacts.sliding_velocity[0];
  const auto turned = particle_stresses(state, {.sliding_resistance = c_t});
  for (int row = 0; row < 2; ++row)
    EXPECT_LT((turned[row] - turn * flat[row] * turn.transpose()).norm(), 1e-12 * flat[0].norm());
}

}  // namespace
}  // namespace frit::observe
