// What must not matter: place, direction and order of the particles, and the units of length and energy.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "network/samples.hpp"

namespace frit::network {
namespace {

using namespace testing;

const double duration = 0.05;

contact::SinteringLaw sliding_law() {
  contact::SinteringLaw law = copper;
  law.sliding_resistance = 0.05;
  return law;
}

// Displacements [m] and rotations of a free step with prospects, as the first pass of a step makes it.
struct Moved {
  std::vector<Vec3> displacement, rotation;
};
Moved solve_step(const State& state, const contact::SinteringLaw& law, double theta) {
  Conditions conditions = step_of(duration);
  conditions.theta = theta;
  const std::vector<contact::Prospect> prospects =
      contact::find_prospects(state, 0.1 * scale_of(state.particles, law).length);
  const StepInput input = input_of(state, conditions, law, prospects);
  const solve::Problem problem = make_problem(input, nullptr);
  solve::Solution found = make_start(input, problem);
  EXPECT_TRUE(solve::solve_newton(problem, {.tolerance = 1e-11}, found).converged);
  Moved moved;
  for (std::size_t n = 0; n < state.particles.size(); ++n) {
    moved.displacement.push_back(displacement(input, found, n));
    moved.rotation.push_back(three(found.motion, 6 * n + 3));
  }
  return moved;
}

State packing() { return random_packing({.spacing = 1.8, .smallest = 0.9}, 11, sliding_law()); }

double largest(const std::vector<Vec3>& values) {
  double result = 0.0;
  for (const Vec3& value : values) result = std::max(result, value.norm());
  return result;
}

TEST(Shift, ChangesNothing) {
  const State state = packing();
  State shifted = state;
  for (Vec3& x : shifted.particles.position) x += Vec3(3.0, -7.0, 11.0) * R;
  const Moved a = solve_step(state, sliding_law(), duration * delta_b);
  const Moved b = solve_step(shifted, sliding_law(), duration * delta_b);
  for (std::size_t n = 0; n < a.displacement.size(); ++n) {
    EXPECT_LT((a.displacement[n] - b.displacement[n]).norm(), 1e-6 * largest(a.displacement));
  }
}

TEST(Rotation, OfThePackingRotatesTheMotion) {
  const State state = packing();
  State turned = state;
  const Mat3 turn = Eigen::AngleAxisd(1.1, Vec3(1.0, 2.0, -1.0).normalized()).toRotationMatrix();
  for (Vec3& x : turned.particles.position) x = turn * x;
  const Moved a = solve_step(state, sliding_law(), duration * delta_b);
  const Moved b = solve_step(turned, sliding_law(), duration * delta_b);
  for (std::size_t n = 0; n < a.displacement.size(); ++n) {
    EXPECT_LT((turn * a.displacement[n] - b.displacement[n]).norm(), 1e-5 * largest(a.displacement));
    EXPECT_LT((turn * a.rotation[n] - b.rotation[n]).norm(), 1e-5 * (largest(a.rotation)));
  }
}

TEST(Relabelling, PermutesTheMotion) {
  const State state = packing();
  const std::size_t count = state.particles.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  Dice dice(12);
  for (std::size_t n = count - 1; n > 0; --n) {
    std::swap(order[n], order[static_cast<std::size_t>(dice.below(static_cast<int>(n) + 1))]);
  }
  State relabelled;
  for (const std::size_t n : order)
    add_sphere(relabelled, state.particles.position[n], state.particles.radius[n]);
  contact::find_initial_contacts(relabelled, sliding_law(), PackingOptions{}.neck_ratio);
  const Moved a = solve_step(state, sliding_law(), duration * delta_b);
  const Moved b = solve_step(relabelled, sliding_law(), duration * delta_b);
  for (std::size_t n = 0; n < count; ++n) {
    EXPECT_LT((a.displacement[order[n]] - b.displacement[n]).norm(), 1e-6 * largest(a.displacement));
  }
}

TEST(Mirror, OfThePackingMirrorsTheMotionAndTurnsSpinsRound) {
  const State state = packing();
  State mirrored = state;
  for (Vec3& x : mirrored.particles.position) x.z() = -x.z();
  const Moved a = solve_step(state, sliding_law(), duration * delta_b);
  const Moved b = solve_step(mirrored, sliding_law(), duration * delta_b);
  for (std::size_t n = 0; n < a.displacement.size(); ++n) {
    const Vec3 moved = a.displacement[n].cwiseProduct(Vec3(1.0, 1.0, -1.0));
    const Vec3 turned = a.rotation[n].cwiseProduct(Vec3(-1.0, -1.0, 1.0));
    EXPECT_LT((moved - b.displacement[n]).norm(), 1e-6 * largest(a.displacement));
    EXPECT_LT((turned - b.rotation[n]).norm(), 1e-6 * largest(a.rotation));
  }
}

// Lengths a thousandfold, energies per area sevenfold, theta and masses to match: the same numbers inside.
TEST(Units, AreTakenOutOfTheProblem) {
  const State state = packing();
  contact::SinteringLaw law = sliding_law(), strong = law;
  strong.surface_energy *= 7.0;
  State large = state;
  for (Vec3& x : large.particles.position) x *= 1e3;
  for (double& radius : large.particles.radius) radius *= 1e3;
  for (double& mass : large.particles.mass) mass *= 7.0;  // force / length stays but for the energy
  contact::find_initial_contacts(large, strong, PackingOptions{}.neck_ratio);
  Conditions conditions = step_of(duration), other = conditions;
  other.theta = conditions.theta * 1e12 / 7.0;
  const StepInput small_input = input_of(state, conditions, law),
                  large_input = input_of(large, other, strong);
  const solve::Problem a = make_problem(small_input, nullptr), b = make_problem(large_input, nullptr);
  const auto close = [](double one, double two) { return std::abs(one - two) <= 1e-11 * std::abs(one); };
  ASSERT_EQ(a.edges.size(), b.edges.size());
  for (std::size_t k = 0; k < a.edges.size(); ++k) {
    const solve::NormalResponse &r = a.edges[k].response, &s = b.edges[k].response;
    EXPECT_TRUE(close(r.viscosity, s.viscosity) && close(r.growth, s.growth) && close(r.cap, s.cap));
    EXPECT_TRUE(close(r.start, s.start) && close(r.pull, s.pull) && close(r.threshold, s.threshold));
    EXPECT_TRUE(close(a.edges[k].sliding, b.edges[k].sliding) && close(a.edges[k].arm_i, b.edges[k].arm_i));
  }
  for (std::size_t n = 0; n < a.bodies(); ++n) {
    EXPECT_TRUE(close(a.mass[n], b.mass[n]) && close(a.moment[n], b.moment[n]));
  }
  EXPECT_TRUE(close(a.force_unit, b.force_unit));
}

}  // namespace
}  // namespace frit::network
