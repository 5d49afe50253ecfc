// The response of a step against the law integrated in time: dr/dt = (R/r) V_n, V_n = (f_n + f_a) / c_n.
#include "contact/local_response.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace frit::contact {
namespace {

const SinteringLaw law{
    .surface_energy = 1.72, .dihedral_angle = 146.0 * pi / 180.0, .sliding_resistance = 0.02};
constexpr double R = 5e-6, delta_b = 2.37e-28;
const Pairing equal(R, R);

using ForceHistory = std::function<double(double time)>;

// Neck radius after `duration` under a given normal force, by the classical fourth order rule.
double integrate_law(const SinteringLaw& which, const Pairing& pair, double r, double duration,
                     const ForceHistory& force) {
  const int steps = 4000;
  const double h = duration / steps;
  const auto rate = [&](double time, double radius) {
    const double c_n = pi * std::pow(radius, 4) / (8.0 * delta_b);
    return pair.equivalent / radius * (force(time) + attraction_force(which, pair, radius)) / c_n;
  };
  for (int n = 0; n < steps; ++n) {
    const double t = n * h;
    const double k1 = rate(t, r), k2 = rate(t + 0.5 * h, r + 0.5 * h * k1);
    const double k3 = rate(t + 0.5 * h, r + 0.5 * h * k2), k4 = rate(t + h, r + h * k3);
    r += h / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + k4);
  }
  return r;
}

// f(a) as local_response.hpp defines it, without the multiplier.
double force_of(const LocalResponse& c, double approach) {
  const auto P = [&](double q) {
    q = std::max(q, c.floor);
    return q <= c.cap ? c.viscosity * q * q * q : c.viscosity * c.cap * c.cap * (3.0 * q - 2.0 * c.cap);
  };
  return P(c.start + c.growth * approach) - P(c.start) - c.pull;
}

struct Flow {
  double r0, r1, approach;
};
Flow flow(const Pairing& pair, double ratio, double duration, const ForceHistory& force) {
  const double r0 = ratio * pair.equivalent, r1 = integrate_law(law, pair, r0, duration, force);
  return {r0, r1, (r1 * r1 - r0 * r0) / (2.0 * pair.equivalent)};
}

TEST(Response, IsTheExactFlowUnderAConstantForce) {
  const double f_a = attraction_force(law, equal, 0.0);
  for (const double share : {-0.9, -0.5, 0.0, 1.0, 20.0}) {
    for (const double duration : {1e-3, 1.0, 30.0}) {
      const Flow f = flow(equal, 0.3, duration, [&](double) { return share * f_a; });
      const LocalResponse c = respond(law, equal, {f.r0 * f.r0, f.r1 * f.r1}, delta_b * duration);
      EXPECT_NEAR(force_of(c, f.approach) / f_a, share, 1e-8 + 1e-9 * R / f.approach)
          << share << " " << duration;
    }
  }
}

TEST(Response, IsExactForAPullThatThinsTheNeck) {
  const double f_a = attraction_force(law, equal, 0.0);
  const Flow f = flow(equal, 0.3, 5.0, [&](double) { return -1.5 * f_a; });
  EXPECT_LT(f.r1, f.r0);
  const LocalResponse c = respond(law, equal, {f.r0 * f.r0, f.r1 * f.r1}, delta_b * 5.0);
  EXPECT_NEAR(force_of(c, f.approach) / f_a, -1.5, 1e-8);
}

TEST(Response, GivesTheMeanForceForAnyHistory) {
  const double f_a = attraction_force(law, equal, 0.0), duration = 20.0;
  const auto force = [&](double time) { return f_a * (0.7 * std::sin(0.9 * time) + 0.05 * time); };
  const double mean = f_a * (0.7 * (1.0 - std::cos(0.9 * duration)) / 0.9 / duration + 0.025 * duration);
  const Flow f = flow(equal, 0.3, duration, force);
  const LocalResponse c = respond(law, equal, {f.r0 * f.r0, f.r1 * f.r1}, delta_b * duration);
  EXPECT_NEAR(force_of(c, f.approach) / mean, 1.0, 1e-7);
}

TEST(Response, HoldsForUnequalSpheres) {
  for (const double ratio : {2.0, 20.0}) {
    const Pairing pair(R, ratio * R);
    const double f_a = attraction_force(law, pair, 0.0);
    const Flow f = flow(pair, 0.2, 5.0, [&](double) { return 0.3 * f_a; });
    const LocalResponse c = respond(law, pair, {f.r0 * f.r0, f.r1 * f.r1}, delta_b * 5.0);
    EXPECT_NEAR(force_of(c, f.approach) / f_a, 0.3, 1e-8) << ratio;
  }
}

TEST(Response, OfTheOtherAttractionIsOfSecondOrder) {
  SinteringLaw other = law;
  other.attraction = Attraction::parhami_mcmeeking;
  double last = 0.0;
  for (const double duration : {0.4, 0.2, 0.1}) {
    const double r0 = 0.3 * R, r1 = integrate_law(other, equal, r0, duration, [](double) { return 0.0; });
    const LocalResponse c = respond(other, equal, {r0 * r0, r1 * r1}, delta_b * duration);
    const double error = std::abs(force_of(c, (r1 * r1 - r0 * r0) / (2.0 * R))) / c.pull;
    EXPECT_LT(error, 1e-3 * duration * duration);
    const double ratio = last > 0.0 ? last / error : 4.0;
    EXPECT_NEAR(ratio, 4.0, 0.5);
    last = error;
  }
}

TEST(Response, EndsItsAttractionAtEquilibrium) {
  const double r = 0.5 * R, cap = std::pow(std::sin(73.0 * pi / 180.0) * R, 2);
  const LocalResponse c = respond(law, equal, {r * r, r * r}, delta_b);
  EXPECT_NEAR(c.cap / cap, 1.0, 1e-12);
  EXPECT_NEAR(c.start + c.growth * c.threshold, cap, 1e-12 * cap);
  EXPECT_EQ(c.limit, c.pull);
  const LocalResponse beyond = respond(law, equal, {1.1 * cap, 1.1 * cap}, delta_b);
  EXPECT_LT(beyond.threshold, 0.0);
  EXPECT_NEAR(beyond.threshold, -0.05 * cap / R, 1e-12 * R);
  // The resistance beyond is that of equilibrium.
  EXPECT_NEAR(beyond.sliding / resistances(law, equal, cap, delta_b).sliding, 1.0, 1e-12);
  const double slope = (force_of(beyond, 1e-3 * R) - force_of(beyond, 0.0)) / (1e-3 * R);
  EXPECT_NEAR(slope / resistances(law, equal, cap, delta_b).normal, 1.0, 1e-9);
}

TEST(Response, OfSmallApproachIsTheResistanceOfTheNeck) {
  const double q = 0.09 * R * R, theta = 1e-3 * delta_b, approach = 1e-6 * R;
  const LocalResponse c = respond(law, equal, {q, q}, theta);
  const double slope = (force_of(c, approach) - force_of(c, -approach)) / (2.0 * approach);
  EXPECT_NEAR(slope / resistances(law, equal, q, theta).normal, 1.0, 1e-8);
  EXPECT_DOUBLE_EQ(c.sliding, resistances(law, equal, q, theta).sliding);
}

TEST(Response, OpensFreelyOnlyWhenUnilateral) {
  SinteringLaw unilateral = law;
  unilateral.pull = Pull::unilateral;
  EXPECT_TRUE(respond(unilateral, equal, {1e-12, 1e-12}, delta_b).opens_freely);
  EXPECT_FALSE(respond(law, equal, {1e-12, 1e-12}, delta_b).opens_freely);
}

TEST(ClosingResponse, ResistsOnlyOnceTheGapIsClosed) {
  const double gap = 1e-8;
  const LocalResponse c = respond_closing(law, equal, {.gap = gap, .approach = 0.0}, delta_b);
  EXPECT_EQ(force_of(c, 0.0), 0.0);
  EXPECT_EQ(force_of(c, gap), 0.0);
  // From the touch on it is a neck of that radius: the same force as (7) gives it.
  const double beyond = 1e-9, born = born_neck_squared(law, equal, 0.0);
  const LocalResponse neck = respond(law, equal, {born, born}, delta_b);
  EXPECT_NEAR(force_of(c, gap + beyond), force_of(neck, beyond) + neck.pull, 1e-9 * neck.pull);
  EXPECT_EQ(c.limit, 0.0);
  EXPECT_EQ(c.sliding, 0.0);
}

TEST(ClosingResponse, AttractsForThePartOfTheStepAfterTheTouch) {
  const double f_a = attraction_force(law, equal, 0.0), gap = 1e-8;
  EXPECT_EQ(respond_closing(law, equal, {gap, 0.99 * gap}, delta_b).pull, 0.0);
  EXPECT_NEAR(respond_closing(law, equal, {gap, 4.0 * gap}, delta_b).pull, 0.75 * f_a, 1e-12 * f_a);
  EXPECT_NEAR(respond_closing(law, equal, {0.0, 1e-9}, delta_b).pull, f_a, 1e-12 * f_a);
  EXPECT_NEAR(respond_closing(law, equal, {gap, 1e6 * gap}, delta_b).pull, f_a, 1e-5 * f_a);
}

TEST(RigidResponse, IsSignorinisCondition) {
  const LocalResponse c = respond_rigid(2e-8);
  EXPECT_EQ(c.threshold, 2e-8);
  EXPECT_EQ(c.limit, std::numeric_limits<double>::infinity());
  EXPECT_EQ(c.viscosity + c.pull + c.sliding, 0.0);
}

}  // namespace
}  // namespace frit::contact
