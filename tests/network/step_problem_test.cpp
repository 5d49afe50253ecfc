#include "network/step_problem.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "network/samples.hpp"
#include "solve/gradient.hpp"

namespace frit::network {
namespace {

using namespace testing;

// Forces [N] and moments [N m] that the necks put on the particles for given velocities and spins.
struct Wrench {
  Vec3 force, moment;
};
struct Motion {
  Vec3 velocity = Vec3::Zero(), spin = Vec3::Zero();
};

std::vector<Wrench> wrenches(const State& state, const contact::SinteringLaw& law,
                             const std::vector<Motion>& motions) {
  const double dt = 1e-9;  // so short that no neck grows
  Conditions conditions = step_of(dt);
  conditions.inertia = Inertia::vanishing;
  const StepInput input = input_of(state, conditions, law);
  const solve::Problem problem = make_problem(input, nullptr);
  solve::Solution at = solve::Solution::at_rest(problem);
  for (std::size_t n = 0; n < motions.size(); ++n) {
    put(at.motion, 6 * n, motions[n].velocity * dt / input.scale.length);
    put(at.motion, 6 * n + 3, motions[n].spin * dt);
  }
  solve::Gradient gradient(problem);
  gradient.evaluate(at, std::vector<double>(problem.edges.size(), 0.0), solve::Multipliers::given);
  std::vector<Wrench> result;
  for (std::size_t n = 0; n < motions.size(); ++n) {
    result.push_back({-input.scale.force * three(gradient.values(), 6 * n),
                      -input.scale.force * input.scale.length * three(gradient.values(), 6 * n + 3)});
  }
  return result;
}

constexpr double typical = 1e-9;  // [m/s]

TEST(TwoSpheres, FeelTheNormalForceOfTheLaw) {
  for (const double ratio : {1.0, 3.0, 20.0}) {
    const State state = two_spheres({.radius_j = ratio * R, .overlap = 0.05 * R});
    const contact::Pairing pair(R, ratio * R);
    const double q = state.contacts.neck_radius_squared[0];
    const double f_a = contact::attraction_force(copper, pair, 0.0);
    const double c_n = contact::resistances(copper, pair, q, delta_b).normal;
    for (const double V_n : {0.0, typical, -3.0 * typical}) {
      const auto on = wrenches(state, copper, {{.velocity = Vec3(V_n, 0.0, 0.0)}, {}});
      const double f_n = c_n * V_n - f_a;  // > 0 repels: pushes the first sphere to -x
      EXPECT_NEAR(on[0].force.x(), -f_n, 1e-6 * f_a) << ratio;
      EXPECT_NEAR(on[1].force.x(), f_n, 1e-6 * f_a) << ratio;
      EXPECT_LT(on[0].moment.norm(), 1e-20);
    }
  }
}

TEST(TwoSpheres, FeelTheSlidingForceOfTheLawWithItsTorques) {
  contact::SinteringLaw law = copper;
  law.sliding_resistance = 0.02;
  for (const double ratio : {1.0, 3.0}) {
    const State state = two_spheres({.radius_j = ratio * R, .overlap = 0.05 * R}, law);
    const contact::Pairing pair(R, ratio * R);
    const double c_t =
        contact::resistances(law, pair, state.contacts.neck_radius_squared[0], delta_b).sliding;
    const double distance = (1.0 + ratio) * R - 0.05 * R;
    const double l_i = distance / (1.0 + ratio), l_j = distance - l_i;
    const Vec3 u(0.0, typical, 0.0), spin(0.0, 0.0, 2.0 * typical / R);
    const Vec3 x = Vec3::UnitX();
    const auto on = wrenches(state, law, {{u, spin}, {-0.5 * u, 0.3 * spin}});
    const Vec3 sliding = 1.5 * u + l_i * spin.cross(x) + 0.3 * l_j * spin.cross(x);
    EXPECT_LT(((on[0].force + c_t * sliding).cwiseProduct(Vec3(0.0, 1.0, 1.0))).norm(), 1e-9 * c_t * typical);
    EXPECT_LT((on[0].force + on[1].force).norm(), 1e-9 * on[0].force.norm());
    EXPECT_LT((on[0].moment + l_i * x.cross(c_t * sliding)).norm(), 1e-9 * c_t * typical * R);
    EXPECT_LT((on[1].moment + l_j * x.cross(c_t * sliding)).norm(), 1e-9 * c_t * typical * R);
  }
}

TEST(TwoSpheres, FeelRollingAndTwistingWhenAsked) {
  contact::SinteringLaw law = copper;
  law.sliding_resistance = 0.02;
  law.neck_bending = true;
  const State state = two_spheres({.overlap = 0.05 * R}, law);
  const contact::Resistances c =
      contact::resistances(law, contact::Pairing(R, R), state.contacts.neck_radius_squared[0], delta_b);
  const Vec3 spin(3e-4, 5e-4, 0.0);
  const auto on = wrenches(state, law, {{.spin = spin}, {.spin = -spin}});  // opposite: no sliding
  EXPECT_NEAR(on[0].moment.x() / (-c.twisting * 2.0 * spin.x()), 1.0, 1e-9);
  EXPECT_NEAR(on[0].moment.y() / (-c.rolling * 2.0 * spin.y()), 1.0, 1e-9);
  EXPECT_LT((on[0].moment + on[1].moment).norm(), 1e-9 * on[0].moment.norm());
}

TEST(TwoSpheres, UnderALoadApproachAsTheLawSays) {
  State state = two_spheres({});
  const double dt = 1e-6, load = 2e-5, f_a = contact::attraction_force(copper, {R, R}, 0.0);
  state.particles.force[0] = Vec3(load, 0.0, 0.0);
  state.particles.force[1] = -state.particles.force[0];
  const StepInput input = input_of(state, step_of(dt));
  const solve::Problem problem = make_problem(input, nullptr);
  solve::Solution found = make_start(input, problem);
  ASSERT_TRUE(solve::solve_newton(problem, {.tolerance = 1e-10}, found).converged);
  const double approach = displacement(input, found, 0).x() - displacement(input, found, 1).x();
  const double expected = 8.0 * delta_b * (f_a + load) / (pi * std::pow(0.3 * R, 4));
  EXPECT_NEAR(approach / dt / expected, 1.0, 1e-5);
}

TEST(Bodies, HaveTheInertiaOfSpheres) {
  const State state = two_spheres({.radius_j = 2.0 * R});
  const StepInput input = input_of(state, step_of(0.5));
  const solve::Problem problem = make_problem(input, nullptr);
  const double unit = input.scale.force / input.scale.length;
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_NEAR(problem.mass[n] * unit / (state.particles.mass[n] / 0.25), 1.0, 1e-12);
    const double moment = 0.4 * state.particles.mass[n] * std::pow(state.particles.radius[n], 2);
    EXPECT_NEAR(problem.moment[n] * input.scale.force * input.scale.length / (moment / 0.25), 1.0, 1e-12);
  }
}

TEST(VanishingInertia, DependsOnVolumesAloneAndIsFarBelowAnyForce) {
  State state = two_spheres({.radius_j = 2.0 * R});
  std::vector<double> first;
  for (const double dt : {1e-6, 1.0}) {
    Conditions conditions = step_of(dt);
    conditions.inertia = Inertia::vanishing;
    const solve::Problem problem = make_problem(input_of(state, conditions), nullptr);
    EXPECT_NEAR(problem.mass[1] / problem.mass[0], 8.0, 1e-12);
    EXPECT_LT(problem.mass[1], 1e-10);
    if (first.empty()) first = problem.mass;
    EXPECT_EQ(problem.mass, first);
    state.particles.mass[0] *= 3.0;
  }
}

TEST(Bodies, KeepTheirVelocityWhenInertiaIsDynamic) {
  State state;
  add_sphere(state, Vec3(1.0, 2.0, 3.0) * R, R);
  state.particles.velocity[0] = Vec3(1e-6, -2e-6, 3e-6);
  state.particles.spin[0] = Vec3(0.1, 0.2, -0.3);
  Conditions conditions = step_of(0.1);
  for (const Inertia inertia : {Inertia::dynamic, Inertia::overdamped}) {
    conditions.inertia = inertia;
    const StepInput input = input_of(state, conditions);
    const solve::Problem problem = make_problem(input, nullptr);
    solve::Solution found = make_start(input, problem);
    ASSERT_TRUE(solve::solve_newton(problem, {}, found).converged);
    const double kept = inertia == Inertia::dynamic ? 1.0 : 0.0;
    EXPECT_LT((displacement(input, found, 0) - kept * 0.1 * state.particles.velocity[0]).norm(), 1e-18);
    EXPECT_LT((three(found.motion, 3) - kept * 0.1 * state.particles.spin[0]).norm(), 1e-13);
  }
}

TEST(Bodies, AreHeldAsAsked) {
  State state = two_spheres({});
  state.particles.fixed[1] = 1;
  Conditions conditions = step_of(1.0);
  EXPECT_EQ(make_problem(input_of(state, conditions), nullptr).held, (std::vector<std::uint8_t>{0, 3}));
  conditions.spins_blocked = true;
  EXPECT_EQ(make_problem(input_of(state, conditions), nullptr).held, (std::vector<std::uint8_t>{2, 3}));
  conditions.freedom = Freedom::affine;
  EXPECT_EQ(make_problem(input_of(state, conditions), nullptr).held, (std::vector<std::uint8_t>{3, 3}));
}

TEST(Edges, AreTheNecksAndThenTheProspects) {
  State state = two_spheres({});
  add_sphere(state, Vec3(4.05 * R, 0.0, 0.0), R);
  const std::vector<contact::Prospect> prospects = contact::find_prospects(state, 0.1 * R);
  ASSERT_EQ(prospects.size(), 1U);
  solve::Problem problem = make_problem(input_of(state, step_of(1.0), copper, prospects), nullptr);
  ASSERT_EQ(problem.edges.size(), 2U);
  EXPECT_GT(problem.edges[0].response.pull, 0.0);
  EXPECT_NEAR(problem.edges[1].response.start, 0.03 * 0.03 - 0.1, 1e-9);
  EXPECT_EQ(problem.edges[1].response.pull, 0.0);
  contact::SinteringLaw rigid = copper;
  rigid.closing = contact::Closing::rigid;
  problem = make_problem(input_of(state, step_of(1.0), rigid, prospects), nullptr);
  EXPECT_NEAR(problem.edges[1].response.threshold, 0.05, 1e-9);
  EXPECT_TRUE(std::isinf(problem.edges[1].response.limit));
}

TEST(Rattlers, AreCarriedByTheParticlesAroundThem) {
  State state;
  for (const double x : {0.0, 1.99, 4.02, 6.05, 8.04}) add_sphere(state, Vec3(x * R, 0.0, 0.0), R);
  contact::find_initial_contacts(state, copper, 0.1);
  ASSERT_EQ(state.contacts.size(), 2U);  // 0-1 and 3-4; the middle one has gaps on both sides
  const std::vector<contact::Prospect> prospects = contact::find_prospects(state, 0.1 * R);
  const StepInput input = input_of(state, step_of(1e-3), copper, prospects);
  solve::Problem problem = make_problem(input, nullptr);
  solve::Solution estimate = solve::Solution::at_rest(problem);
  put(estimate.motion, 6, Vec3(0.001, 0.002, 0.0));
  put(estimate.motion, 18, Vec3(0.003, 0.0, 0.0));
  problem = make_problem(input, &estimate);
  EXPECT_LT((problem.carried[2] - Vec3(0.002, 0.001, 0.0)).norm(), 1e-12);
  EXPECT_EQ(problem.carried[1].norm(), 0.0);
  EXPECT_EQ(problem.load[2].norm(), 0.0);
}

TEST(ForceUnit, IsTheNormOfTheDrivingForces) {
  State state = two_spheres({});
  state.particles.force[0] = Vec3(3e-5, 0.0, 4e-5);
  const StepInput input = input_of(state, step_of(1e6));  // inertia adds nothing
  const double f_a = contact::attraction_force(copper, {R, R}, 0.0);
  const double expected = std::sqrt(2.0 * f_a * f_a + 25e-10);
  EXPECT_NEAR(make_problem(input, nullptr).force_unit * input.scale.force / expected, 1.0, 1e-9);
}

}  // namespace
}  // namespace frit::network
