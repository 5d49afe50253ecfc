// The methods beside each other: explicit, implicit with real and with vanishing mass, affine.
#include <gtest/gtest.h>

#include <cmath>

#include "integrate/samples.hpp"
#include "integrate/verlet_step.hpp"

namespace frit::integrate {
namespace {

using namespace testing;

VerletSettings explicit_settings(const StepSettings& implicit, double factor) {
  VerletSettings settings;
  settings.law = implicit.law;
  settings.density_factor = factor;
  settings.stress = implicit.stress;
  settings.strain_rate = implicit.strain_rate;
  return settings;
}

State advance_explicitly(State state, const VerletSettings& settings, double duration) {
  const Furnace furnace = holding();
  VerletStep stepper(settings, furnace);
  for (double left = duration; left > 0.0;) {
    const StepReport report = stepper.attempt(state, left, state);
    EXPECT_EQ(report.verdict, Verdict::accepted);
    if (report.verdict != Verdict::accepted) break;
    left = report.duration == left ? 0.0 : left - report.duration;
  }
  return state;
}

// Root mean square distance of the particles of two states [m].
double distance(const State& a, const State& b) {
  double squares = 0.0;
  for (std::size_t n = 0; n < a.particles.size(); ++n) {
    squares += (a.particles.position[n] - b.particles.position[n]).squaredNorm();
  }
  return std::sqrt(squares / static_cast<double>(a.particles.size()));
}

StepSettings resisted() {
  StepSettings settings = exact_settings();
  settings.law.sliding_resistance = 0.05;
  settings.law.neck_bending = true;  // no mechanism is left free
  settings.tolerance = 1e-9;
  return settings;
}

TEST(FiveHundredParticles, MoveByVerletAsByContactDynamicsWhenTheFactorFalls) {
  const StepSettings settings = resisted();
  const State start =
      random_packing({.edge_count = 8, .spacing = 1.85, .neck_ratio = 0.25}, 61, settings.law);
  ASSERT_EQ(start.particles.size(), 512U);
  const double time = time_of(2e-5);
  const State implicit = advance(start, settings, time, 60);
  ASSERT_EQ(implicit.contacts.size(), start.contacts.size()) << "no births wanted here";
  const double moved = distance(implicit, start);
  double last = 0.0, error = 0.0;
  for (const double factor : {1e16, 1e15, 1e14}) {
    error = distance(advance_explicitly(start, explicit_settings(settings, factor), time), implicit) / moved;
    EXPECT_GT(last > 0.0 ? last / error : 10.0, 3.0) << factor << " error " << error;
    last = error;
  }
  EXPECT_LT(error, 0.01);
}

TEST(Paths, OfVerletAreThoseOfContactDynamics) {
  const StepSettings settings = resisted();
  const State start = random_packing({.spacing = 1.8, .neck_ratio = 0.25}, 64, settings.law);
  const double time = time_of(2e-5);
  const Contacts exact = advance(start, settings, time, 60).contacts;
  const Contacts found = advance_explicitly(start, explicit_settings(settings, 1e13), time).contacts;
  ASSERT_EQ(found.size(), exact.size());
  double rolled = 0.0, slid = 0.0, off_rolled = 0.0, off_slid = 0.0;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    rolled += exact.rolling_path[k];
    slid += exact.sliding_path[k];
    off_rolled += std::abs(found.rolling_path[k] - exact.rolling_path[k]);
    off_slid += std::abs(found.sliding_path[k] - exact.sliding_path[k]);
  }
  EXPECT_GT(rolled, 0.0);
  EXPECT_LT(off_rolled, 0.02 * rolled);
  EXPECT_LT(off_slid, 0.02 * slid);
}

TEST(QuasiStatic, IsContactDynamicsWhereEveryMotionIsResisted) {
  StepSettings settings = resisted();
  const State start = random_packing({.spacing = 1.8}, 62, settings.law);
  const State real = advance(start, settings, time_of(1e-4), 5);
  settings.inertia = network::Inertia::vanishing;
  EXPECT_LT(distance(advance(start, settings, time_of(1e-4), 5), real), 1e-5 * distance(real, start));
}

TEST(QuasiStatic, DoesNotCareForTheDensityOfTheMaterial) {
  StepSettings settings = exact_settings();  // eta = 0: mechanisms everywhere
  settings.inertia = network::Inertia::vanishing;
  const State start = random_packing({.spacing = 1.9}, 63, settings.law);
  State heavy = start;
  for (double& mass : heavy.particles.mass) mass *= 1e3;
  EXPECT_EQ(advance(start, settings, time_of(1e-6), 3).particles.position,
            advance(heavy, settings, time_of(1e-6), 3).particles.position);
}

struct Lattice {
  const char* name;
  double edge;               // of the unit cell, in R
  std::vector<Vec3> places;  // in edges
};

TEST(Lattices, HaveTheSameDensityByAllMethods) {
  const Lattice lattices[] = {
      {"simple cubic", 2.0, {Vec3(0, 0, 0)}},
      {"body-centred cubic", 4.0 / std::sqrt(3.0), {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0.5)}},
      {"face-centred cubic",
       2.0 * std::sqrt(2.0),
       {Vec3(0, 0, 0), Vec3(0.5, 0.5, 0), Vec3(0.5, 0, 0.5), Vec3(0, 0.5, 0.5)}}};
  const double time = time_of(1e-4), x = sixth_root(std::pow(0.3, 6) + 54e-4);
  for (const Lattice& lattice : lattices) {
    State start;
    start.cell = {.periodic = true, .size = Vec3::Constant(2.0 * lattice.edge * R)};
    for (int copy = 0; copy < 8; ++copy) {
      for (const Vec3& place : lattice.places) {
        const Vec3 corner(copy % 2, copy / 2 % 2, copy / 4);
        add_sphere(start, lattice.edge * R * (corner + place), R);
      }
    }
    StepSettings settings = exact_settings();
    settings.tolerance = 1e-9;
    settings.law.sliding_resistance = 0.01;
    contact::find_initial_contacts(start, settings.law, 0.3);
    // Approach of the centres (x^2 - x_0^2) R / 2 of 2 R.
    const double exact = std::pow(1.0 - (x * x - 0.09) / 4.0, 3);
    const auto shrunk = [&](const State& end) { return end.cell.volume() / start.cell.volume(); };
    EXPECT_NEAR(shrunk(advance(start, settings, time, 3)) / exact, 1.0, 1e-5) << lattice.name;
    EXPECT_NEAR(shrunk(advance_explicitly(start, explicit_settings(settings, 1e14), time)) / exact, 1.0, 2e-4)
        << lattice.name;
    settings.inertia = network::Inertia::vanishing;
    EXPECT_NEAR(shrunk(advance(start, settings, time, 3)) / exact, 1.0, 1e-5) << lattice.name;
    settings.inertia = network::Inertia::overdamped;
    settings.freedom = network::Freedom::affine;
    EXPECT_NEAR(shrunk(advance(start, settings, time, 3)) / exact, 1.0, 1e-5) << lattice.name;
  }
}

// Affine estimates for small overlaps: docs/theory.md, section 6; exact for cubic lattices.
TEST(MeanField, OfASimpleCubicLatticeHasTheSinteringStressAndTheViscosityOfTheClosedForms) {
  State start;
  start.cell = {.periodic = true, .size = Vec3::Constant(2.0 * R)};
  add_sphere(start, Vec3::Zero(), R);
  contact::find_initial_contacts(start, copper, 0.3);
  StepSettings settings = exact_settings();
  settings.freedom = network::Freedom::affine;
  const double D = pi / 6.0, Z = 6.0, dt = 1e-6;
  const double sintering_stress = 9.0 / 32.0 * D * Z * copper.surface_energy / R;
  const double bulk_viscosity = D * Z * std::pow(0.3 * R, 4) / (48.0 * R * held_delta_b());
  settings.stress = Vec3::Constant(sintering_stress);  // tension that stops shrinkage
  const State held = advance(start, settings, dt, 1);
  settings.stress = Vec3::Zero();
  const State free = advance(start, settings, dt, 1);
  EXPECT_LT(std::abs(held.cell_rate.x()), 1e-5 * std::abs(free.cell_rate.x()));
  EXPECT_NEAR(free.cell_rate.sum() * bulk_viscosity / -sintering_stress, 1.0, 1e-5);
}

TEST(VerletCell, UnderStressShrinksWithTheRateOfTheLawBehindByItsInertia) {
  State start;
  start.cell = {.periodic = true, .size = Vec3::Constant(2.0 * R)};
  add_sphere(start, Vec3::Zero(), R);
  contact::find_initial_contacts(start, copper, 0.3);
  StepSettings settings = exact_settings();
  settings.stress = Vec3(-2e6, 1e6, 0.0);
  const double time = 0.2;
  const State implicit = advance(start, settings, time, 20);
  Vec3 last = Vec3::Zero();
  for (const double inertia : {1.0, 10.0}) {
    VerletSettings light = explicit_settings(settings, 1e13);
    light.cell_inertia = inertia;
    const State end = advance_explicitly(start, light, time);
    for (int axis = 0; axis < 3; ++axis) {
      const double behind = 1.0 - end.cell_strain[axis] / implicit.cell_strain[axis];
      EXPECT_LT(behind, 3e-3 * inertia) << axis << " " << inertia;
      EXPECT_NEAR(last[axis] > 0.0 ? behind / last[axis] : 10.0, 10.0, 0.7) << axis;
      last[axis] = behind;
    }
  }
}

TEST(VerletCell, FollowsAPrescribedRateExactly) {
  StepSettings settings = exact_settings();
  settings.law.sliding_resistance = 0.05;
  const double time = time_of(1e-5);
  settings.strain_rate = Vec3(-0.01, 0.02, 0.0) / time;
  const State start = random_packing({.spacing = 1.85, .periodic = true}, 31, settings.law);
  const State end = advance_explicitly(start, explicit_settings(settings, 1e14), time);
  EXPECT_NEAR(end.cell_strain.x(), -0.01, 1e-12);
  EXPECT_NEAR(end.cell_strain.y(), 0.02, 1e-12);
  EXPECT_NEAR(std::log(end.cell.size.y() / start.cell.size.y()), 0.02, 1e-12);
}

}  // namespace
}  // namespace frit::integrate
