// The limit of explicit steps against the largest eigenvalue of the whole network.
#include "integrate/stable_step.hpp"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

constexpr Lanes<double> none{0.0, 0.0, 0.0, 0.0};

struct Network {
  State state;
  contact::SinteringLaw law;
  VerletList list;
  std::vector<VerletBody> bodies;
  std::vector<VerletInertia> inertia;

  Network(const State& packing, const contact::SinteringLaw& sintering)
      : state(packing), law(sintering), list(state, law, 0.0) {
    for (std::size_t n = 0; n < state.particles.size(); ++n) {
      const double mass = 1e12 * state.particles.mass[n];
      bodies.push_back({lanes<double>(state.particles.position[n]), none, none});
      inertia.push_back({1.0 / mass, 2.5 / (mass * std::pow(state.particles.radius[n], 2)), none});
    }
  }
  VerletForces forces() { return {law, list, bodies, inertia}; }
  StableStepInput input(std::span<const Lanes<double>> shifts) const {
    return {law, bodies, shifts, inertia, held_delta_b(), none};
  }
};

// Rates of M^-1 C, a column for each unit velocity and spin: what one step of 1 s takes from it.
Eigen::MatrixXd rates(Network& network) {
  const std::size_t count = network.bodies.size();
  Eigen::MatrixXd result(6 * count, 6 * count);
  const auto change = [&](const std::vector<VerletBody>& moving) {
    const double dt = 1e-6;
    VerletForces forces(network.law, network.list, moving, network.inertia);
    forces.step({.dt = dt, .delta_b = held_delta_b(), .time = 0.0, .rate = none, .size = none});
    Eigen::VectorXd lost(6 * count);
    for (std::size_t n = 0; n < count; ++n) {
      lost.segment<3>(6 * n) = to_vec3(moving[n].v - forces.bodies()[n].v) / dt;
      lost.segment<3>(6 * n + 3) = to_vec3(moving[n].w - forces.bodies()[n].w) / dt;
    }
    return lost;
  };
  const Eigen::VectorXd at_rest = change(network.bodies);
  for (std::size_t column = 0; column < 6 * count; ++column) {
    std::vector<VerletBody> moving = network.bodies;
    VerletBody& body = moving[column / 6];
    const int axis = static_cast<int>(column % 6);
    const double unit = axis < 3 ? 1.0 : 1.0 / R;
    (axis < 3 ? body.v : body.w)[axis % 3] = unit;
    result.col(static_cast<Eigen::Index>(column)) = (change(moving) - at_rest) / unit;
  }
  return result;
}

TEST(LargestRate, IsABoundAndNotFarAbove) {
  for (const double eta : {0.0, 0.01, 0.3}) {
    contact::SinteringLaw law = copper;
    law.sliding_resistance = eta;
    law.neck_bending = eta > 0.1;
    for (const double neck : {0.15, 0.4}) {
      Network network(random_packing({.spacing = 1.8, .smallest = 0.8, .neck_ratio = neck}, 41, law), law);
      VerletForces forces = network.forces();
      const double bound = largest_rate(network.list, network.input(forces.shifts()));
      const Eigen::EigenSolver<Eigen::MatrixXd> solver(rates(network), false);
      const double exact = solver.eigenvalues().real().maxCoeff();
      EXPECT_GE(bound, (1.0 - 1e-6) * exact) << eta << " " << neck;
      EXPECT_LE(bound, 1.6 * exact) << eta << " " << neck;
    }
  }
}

TEST(LargestRate, OfTwoSpheresIsTwiceTheNecksResistanceOverTheMass) {
  Network network(two_spheres({.neck_ratio = 0.3}), copper);
  VerletForces forces = network.forces();
  const double c_n = contact::resistances(copper, {R, R}, 0.09 * R * R, held_delta_b()).normal;
  EXPECT_NEAR(largest_rate(network.list, network.input(forces.shifts())) /
                  (2.0 * c_n * network.inertia[0].inverse_mass),
              1.0, 1e-9);
}

TEST(InertialNeckRatio, IsThatOfTheListedFigures) {
  const double mass = density * 4.0 / 3.0 * pi * std::pow(R, 3),
               f_a = contact::attraction_force(copper, {R, R}, 0.0);
  EXPECT_NEAR(inertial_neck_ratio(delta_b, f_a, mass, R), 0.007, 0.0005);
  EXPECT_NEAR(inertial_neck_ratio(delta_b, f_a, 1e9 * mass, R), 0.053, 0.0005);
  EXPECT_NEAR(inertial_neck_ratio(delta_b, f_a, 1e12 * mass, R), 0.105, 0.001);
}

}  // namespace
}  // namespace frit::integrate
