// The geometry of mid-step: exact approaches, rigid rotations without any force, cells that deform.
#include <gtest/gtest.h>

#include <cmath>

#include "network/samples.hpp"
#include "solve/gradient.hpp"

namespace frit::network {
namespace {

using namespace testing;

solve::Gradient evaluated(const solve::Problem& problem, const solve::Solution& at) {
  solve::Gradient gradient(problem);
  gradient.evaluate(at, std::vector<double>(problem.edges.size(), 0.0), solve::Multipliers::given);
  return gradient;
}

solve::EdgeAction acting(const solve::Problem& problem, const solve::Solution& at, std::size_t k) {
  return solve::act(problem, k, at.motion, {solve::Multipliers::given, at.multiplier[k], 0.0});
}

// A rotation by this angle about the axis, as displacements and tangent rotation vectors of all particles.
solve::Solution rigid_motion(const StepInput& input, const Vec3& axis, double angle) {
  solve::Solution motion = solve::Solution::at_rest(make_problem(input, nullptr));
  const Mat3 turn = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  const Vec3 shift(0.3, -0.2, 0.7);
  for (std::size_t n = 0; n < input.state.particles.size(); ++n) {
    const Vec3 x = input.state.particles.position[n] / input.scale.length;
    put(motion.motion, 6 * n, turn * x - x + shift);
    put(motion.motion, 6 * n + 3, 2.0 * std::tan(0.5 * angle) * axis);
  }
  return motion;
}

TEST(RigidRotation, OfAnyAngleNeitherApproachesNorSlides) {
  contact::SinteringLaw law = copper;
  law.sliding_resistance = 0.3;
  law.neck_bending = true;
  const State state = random_packing({.spacing = 1.4, .smallest = 0.6}, 1, law);
  const StepInput input = input_of(state, step_of(1.0), law);
  ASSERT_GT(state.contacts.size(), 5U);
  Dice dice(2);
  for (const double degrees : {1e-3, 1.0, 30.0, 90.0, 170.0}) {
    const solve::Solution motion = rigid_motion(input, dice.direction(), degrees * pi / 180.0);
    const solve::Problem problem = make_problem(input, &motion);
    const solve::Gradient at = evaluated(problem, motion);
    const double tolerance = 1e-13 * (1.0 + std::tan(0.5 * degrees * pi / 180.0));
    for (std::size_t k = 0; k < problem.edges.size(); ++k) {
      EXPECT_NEAR(at.approach()[k], 0.0, tolerance) << degrees;
      EXPECT_LT(acting(problem, motion, k).relative.norm(), 10.0 * tolerance) << degrees;
      EXPECT_NEAR(acting(problem, motion, k).normal_force / -problem.edges[k].response.pull, 1.0, 1e-9)
          << degrees;
    }
  }
}

TEST(Approach, IsTheChangeOfDistanceForAnyDisplacement) {
  for (const bool periodic : {false, true}) {
    const State state =
        random_packing({.edge_count = 2, .spacing = 1.4, .smallest = 0.6, .periodic = periodic}, 3);
    const StepInput input = input_of(state, step_of(1.0));
    Dice dice(4);
    solve::Solution motion = solve::Solution::at_rest(make_problem(input, nullptr));
    for (double& value : motion.motion) value = dice.between(-0.3, 0.3);
    if (!periodic) put(motion.motion, 6 * state.particles.size(), Vec3::Zero());
    const solve::Gradient at = evaluated(make_problem(input, &motion), motion);
    const Vec3 stretch = Vec3::Ones() + three(motion.motion, 6 * state.particles.size());
    for (std::size_t k = 0; k < state.contacts.size(); ++k) {
      const auto i = static_cast<std::size_t>(state.contacts.i[k]),
                 j = static_cast<std::size_t>(state.contacts.j[k]);
      const auto& x = state.particles.position;
      Cell cell = state.cell;
      const double before = cell.separation(x[i], x[j], state.contacts.image[k]).norm();
      cell.size = cell.size.cwiseProduct(stretch);
      const Vec3 new_i = x[i] + displacement(input, motion, i), new_j = x[j] + displacement(input, motion, j);
      const double after = cell.separation(new_i, new_j, state.contacts.image[k]).norm();
      EXPECT_NEAR(at.approach()[k], (before - after) / input.scale.length, 1e-13);
    }
  }
}

TEST(LeverArms, ShareTheDistanceAsTheRadiiDo) {
  const State state = two_spheres({.radius_j = 3.0 * R, .overlap = 0.2 * R});
  const solve::Problem problem = make_problem(input_of(state, step_of(1.0)), nullptr);
  const double length = scale_of(state.particles, copper).length;
  EXPECT_NEAR(problem.edges[0].arm_i * length, 3.8 * R / 4.0, 1e-12 * R);
  EXPECT_NEAR(problem.edges[0].arm_j * length, 3.8 * R * 3.0 / 4.0, 1e-12 * R);
}

TEST(CellAxes, BalanceStressTimesVolumeWithTheVirial) {
  const State state = random_packing({.periodic = true}, 5);
  Conditions conditions = step_of(0.1);
  conditions.stress = Vec3(-2e5, 1e5, 0.0);  // [Pa]
  const StepInput input = input_of(state, conditions);
  const solve::Problem problem = make_problem(input, nullptr);
  solve::Solution found = make_start(input, problem);
  ASSERT_TRUE(solve::solve_newton(problem, {.tolerance = 1e-10}, found).converged);
  Vec3 virial = Vec3::Zero();  // [N m]: no sliding resistance, so forces are along the normals
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    const auto i = static_cast<std::size_t>(state.contacts.i[k]),
               j = static_cast<std::size_t>(state.contacts.j[k]);
    const Vec3 branch = state.cell.separation(state.particles.position[i], state.particles.position[j],
                                              state.contacts.image[k]);
    const double repulsion = acting(problem, found, k).normal_force * input.scale.force;
    virial -= repulsion * branch.normalized().cwiseProduct(branch);
  }
  const Vec3 stress = virial / state.cell.volume();
  EXPECT_LT((stress - conditions.stress).norm(), 1e-4 * 2e5);
}

TEST(CellAxes, UseTheFacesOfMidStep) {
  State state = random_packing({.periodic = true}, 6);
  state.cell.size = Vec3(1.0, 2.0, 4.0) * 3.0 * R;
  Conditions conditions = step_of(1.0);
  conditions.stress = Vec3(1e5, 2e5, 3e5);
  const StepInput input = input_of(state, conditions);
  solve::Solution estimate = solve::Solution::at_rest(make_problem(input, nullptr));
  const Vec3 gradient(-0.2, -0.1, 0.4);
  put(estimate.motion, 6 * state.particles.size(), gradient);
  const solve::Problem problem = make_problem(input, &estimate);
  const Vec3 middle = state.cell.size.cwiseProduct(Vec3::Ones() + 0.5 * gradient);
  for (int axis = 0; axis < 3; ++axis) {
    const double face = middle.prod() / middle[axis];
    const double expected = conditions.stress[axis] * face * state.cell.size[axis];  // [N m]
    EXPECT_NEAR(problem.axis_load[axis] * input.scale.force * input.scale.length / expected, 1.0, 1e-12);
  }
}

TEST(CellAxes, AreHeldWherePrescribed) {
  const State state = random_packing({.periodic = true}, 7);
  Conditions conditions = step_of(1.0);
  conditions.axis_prescribed = {true, false, true};
  conditions.axis_gradient = Vec3(-0.01, 5.0, 0.02);
  const StepInput input = input_of(state, conditions);
  const solve::Problem problem = make_problem(input, nullptr);
  EXPECT_EQ(problem.axis_held, (std::array<bool, 3>{true, false, true}));
  const solve::Solution start = make_start(input, problem);
  EXPECT_EQ(three(start.motion, 6 * state.particles.size()), Vec3(-0.01, 0.0, 0.02));
}

TEST(AffineFreedom, MovesEveryParticleWithTheStrain) {
  for (const bool periodic : {false, true}) {
    const State state = random_packing({.spacing = 1.5, .smallest = 0.7, .periodic = periodic}, 8);
    Conditions conditions = step_of(0.1);
    conditions.freedom = Freedom::affine;
    const StepInput input = input_of(state, conditions);
    const solve::Problem problem = make_problem(input, nullptr);
    EXPECT_TRUE(problem.has_axes);
    solve::Solution found = make_start(input, problem);
    ASSERT_TRUE(solve::solve_newton(problem, {}, found).converged);
    const Vec3 strain = three(found.motion, 6 * state.particles.size());
    EXPECT_LT(strain.maxCoeff(), 0.0);
    for (std::size_t n = 0; n < state.particles.size(); ++n) {
      const Vec3 expected = strain.cwiseProduct(state.particles.position[n]);
      EXPECT_LT((displacement(input, found, n) - expected).norm(), 1e-18);
    }
  }
}

TEST(Start, TakesTheMultipliersOfTheLastStep) {
  State state = two_spheres({});
  state.contacts.equilibrium_force[0] = 1e-6;
  const StepInput input = input_of(state, step_of(1.0));
  const solve::Solution start = make_start(input, make_problem(input, nullptr));
  EXPECT_NEAR(start.multiplier[0], 1e-6 / (1.72 * R), 1e-12);
}

}  // namespace
}  // namespace frit::network
