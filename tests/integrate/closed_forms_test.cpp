// Chains, lattices and the other attraction against their closed forms.
#include <gtest/gtest.h>

#include <cmath>

#include "integrate/samples.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

// tau of a neck from 0 to x with the attraction of Parhami & McMeeking: integral of x^5 / (8 F(x) / pi).
double parhami_tau(double x) {
  const double half = 73.0 * pi / 180.0;
  const auto integrand = [&](double s) {
    return std::pow(s, 5) / (8.0 * (4.0 * (1.0 - std::cos(half)) + s * std::sin(half)));
  };
  const int panels = 20000;
  double sum = integrand(0.0) + integrand(x);
  for (int n = 1; n < panels; ++n) sum += (n % 2 == 1 ? 4.0 : 2.0) * integrand(x * n / panels);
  return sum * x / panels / 3.0;
}

StepSettings parhami() {
  StepSettings settings = exact_settings();
  settings.law.attraction = contact::Attraction::parhami_mcmeeking;
  return settings;
}

TEST(ParhamiMcMeeking, ReachesTheKnownNecksWithSecondOrder) {
  for (const auto& [x, tau] : {std::pair{0.3, 4.937e-6}, {0.5, 1.005e-4}, {0.7, 7.204e-4}}) {
    ASSERT_NEAR(parhami_tau(x) / tau, 1.0, 1e-3) << "the reference";
    const double time = time_of(parhami_tau(x) - parhami_tau(0.8 * x));
    double last = 0.0;
    for (const int steps : {4, 8, 16}) {
      const double error =
          std::abs(neck_ratio(advance(two_spheres({.neck_ratio = 0.8 * x}), parhami(), time, steps)) - x);
      EXPECT_LT(error, 1e-3) << x << " " << steps;
      const double order = last > 0.0 ? std::log2(last / error) : 2.0;
      EXPECT_GT(order, 1.9) << x << " " << steps;
      last = error;
    }
  }
}

TEST(ParhamiMcMeeking, ConvergesToTheKnownNeck) {
  const double time = time_of(parhami_tau(0.5) - parhami_tau(0.3));
  EXPECT_NEAR(neck_ratio(advance(two_spheres({.neck_ratio = 0.3}), parhami(), time, 200)), 0.5, 1e-6);
}

State chain_of_eight() {
  State state;
  for (int n = 0; n < 8; ++n) add_sphere(state, Vec3(2.0 * R * n, 0.0, 0.0), R);
  contact::find_initial_contacts(state, copper, 0.1);
  for (std::size_t k = 0; k < 7; ++k) {
    const double x = 0.1 + 0.03 * static_cast<double>(k);
    state.contacts.neck_radius_squared[k] = x * x * R * R;
    state.contacts.birth_neck_radius[k] = x * R;
  }
  return state;
}

TEST(ChainWithRealMass, LetsEveryNeckGrowAsIfAloneForAnyStep) {
  for (const double dt : {1e-8, 1e-6, 1e-3, 1.0, 1e3}) {
    for (const double tolerance : {1e-6, 1e-10}) {
      StepSettings settings = exact_settings();
      settings.tolerance = tolerance;
      const State end = advance(chain_of_eight(), settings, 20.0 * dt, 20);
      const double tau = 20.0 * dt / time_of(1.0);
      ASSERT_EQ(end.contacts.size(), 7U);
      for (std::size_t k = 0; k < 7; ++k) {
        const double x0 = 0.1 + 0.03 * static_cast<double>(k),
                     expected = sixth_root(std::pow(x0, 6) + 54.0 * tau);
        EXPECT_NEAR(neck_ratio(end, k) / std::min(expected, 0.95630476), 1.0, 1e-4) << dt << " " << tolerance;
      }
    }
  }
}

// One sphere and its three copies: every neck grows like that of a free pair.
State simple_cubic() {
  State state;
  state.cell = {.periodic = true, .size = Vec3::Constant(2.0 * R)};
  add_sphere(state, Vec3(0.3, 0.4, 0.5) * R, R);
  contact::find_initial_contacts(state, copper, 0.0);
  state.contacts.neck_radius_squared.assign(3, 0.0);
  return state;
}

double relative_density(const State& state) { return 4.0 / 3.0 * pi * R * R * R / state.cell.volume(); }

TEST(SimpleCubicLattice, DensifiesAsTheClosedFormSays) {
  ASSERT_EQ(simple_cubic().contacts.size(), 3U);
  for (const auto& [density_reached, tau] : {std::pair{0.7, 9.304e-4}, {0.8, 2.711e-3}, {0.9, 5.343e-3}}) {
    const double x = sixth_root(54.0 * tau), expected = pi / 6.0 * std::pow(1.0 - 0.25 * x * x, -3);
    EXPECT_NEAR(expected, density_reached, 2e-4);
    for (const int steps : {1, 10}) {
      for (const network::Freedom freedom : {network::Freedom::particles, network::Freedom::affine}) {
        StepSettings settings = exact_settings();
        settings.freedom = freedom;
        const State end = advance(simple_cubic(), settings, time_of(tau), steps);
        EXPECT_NEAR(relative_density(end) / expected, 1.0, 1e-6) << steps;
        EXPECT_NEAR(neck_ratio(end), x, 1e-6) << steps;
      }
    }
  }
}

TEST(SimpleCubicLattice, OfManySpheresIsTheSameAsOfOne) {
  State state;
  state.cell = {.periodic = true, .size = Vec3::Constant(6.0 * R)};
  for (int n = 0; n < 27; ++n) add_sphere(state, 2.0 * R * Vec3(n % 3, n / 3 % 3, n / 9), R);
  contact::find_initial_contacts(state, copper, 0.1);
  ASSERT_EQ(state.contacts.size(), 81U);
  const double tau = 9e-4, x2 = std::cbrt(1e-6 + 54.0 * tau);
  const State end = advance(state, exact_settings(), time_of(tau), 4);
  const double edge = 6.0 * R * (1.0 - 0.25 * (x2 - 0.01));
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(end.cell.size[axis] / edge, 1.0, 1e-7);
  EXPECT_NEAR(end.cell_strain.sum(), std::log(end.cell.volume() / state.cell.volume()), 1e-12);
}

TEST(SimpleCubicLattice, FollowsATemperatureProgrammeThroughThetaAlone) {
  const Furnace ramp(copper_boundary, 900.0, {{600.0, 0.5}, {100.0, 0.0}, {200.0, -1.0}});
  ImplicitStep step(exact_settings(), ramp);
  State state = simple_cubic();
  for (int n = 0; n < 9; ++n) ASSERT_EQ(step.attempt(state, 100.0, state).verdict, Verdict::accepted);
  const double tau = ramp.theta(0.0, 900.0) * copper.surface_energy / std::pow(R, 4);
  EXPECT_NEAR(neck_ratio(state) / sixth_root(54.0 * tau), 1.0, 1e-7);
  EXPECT_NEAR(state.theta / ramp.theta(0.0, 900.0), 1.0, 1e-12);
  EXPECT_DOUBLE_EQ(state.temperature, 1000.0);
  EXPECT_DOUBLE_EQ(state.time, 900.0);
}

}  // namespace
}  // namespace frit::integrate
