// Cases with closed answers, through the whole run (docs/validation.md).
#include <gtest/gtest.h>

#include <cmath>

#include "run/samples.hpp"

namespace frit::run {
namespace {

using samples::pair_case;
using samples::periodic_case;
using samples::Recorder;
using samples::time_scale;

Recorder recorded(const config::Case& whole) {
  Recorder recorder;
  EXPECT_EQ(run_case(whole, {&recorder}).code, 0);
  return recorder;
}

double free_neck(double x0, double tau) { return std::pow(std::pow(x0, 6) + 54.0 * tau, 1.0 / 6.0); }

TEST(KnownAnswers, TwoFreeSpheresForAnyStep) {
  const io::TemporaryFolder folder;
  for (const std::string step : {"auto", "0.5", "60"}) {
    const auto rows = recorded(pair_case(folder, {"method.time_step=" + step}));
    EXPECT_NEAR(rows.column("neck_ratio_mean").back(), free_neck(0.05, 60.0 / time_scale), 2e-6) << step;
  }
}

TEST(KnownAnswers, TwoUnequalSpheresFollowTheEquivalentRadiusAndKeepTheirCentreOfMass) {
  const io::TemporaryFolder folder;
  const auto whole = pair_case(folder, {"stop.time=20"});
  folder.write("packing.csv", "x,y,z,radius\n0,0,0,2.5e-6\n7.5e-6,0,0,5e-6\n");
  const auto rows = recorded(whole);
  const double share = (10.0 / 3.0) / 5.0, scale = time_scale * std::pow(share, 4);  // R = 10/3 um
  EXPECT_NEAR(rows.column("neck_ratio_mean").back(), free_neck(0.05, 20.0 / scale), 2e-6);
  const Particles& p = rows.last.particles;
  const Vec3 moment = p.mass[0] * p.position[0] + p.mass[1] * p.position[1];
  EXPECT_NEAR(moment.x() / (p.mass[0] + p.mass[1]), 7.5e-6 * 8.0 / 9.0, 1e-14);
}

TEST(KnownAnswers, EquilibriumIsReachedAndKept) {
  const io::TemporaryFolder folder;
  const auto rows = recorded(pair_case(folder, {"stop.time=1e5", "output.every_time=5e3"}));
  const auto necks = rows.column("neck_ratio_mean"), times = rows.column("time [s]");
  const double largest = std::sin(0.5 * 146.0 * pi / 180.0);
  for (std::size_t n = 0; n < necks.size(); ++n)
    EXPECT_NEAR(necks[n], std::min(largest, free_neck(0.05, times[n] / time_scale)), 1e-5) << times[n];
}

TEST(KnownAnswers, ParhamiAndMcMeekingsAttraction) {
  const io::TemporaryFolder folder;
  for (const auto& [tau, x] : {std::pair{4.937e-6, 0.3}, {1.005e-4, 0.5}, {7.204e-4, 0.7}}) {
    const auto rows = recorded(
        pair_case(folder, {"contact.attraction=parhami-mcmeeking", "contact.initial_neck_ratio=0.001",
                           "method.accuracy=0.001", fmt::format("stop.time={}", tau * time_scale)}));
    EXPECT_NEAR(rows.column("neck_ratio_mean").back(), x, 1e-3 * x);
  }
}

TEST(KnownAnswers, ALoadAddsToTheAttraction) {
  const io::TemporaryFolder folder;
  const double load = 1e-4, attraction = 9.0 / 8.0 * pi * samples::radius * samples::gamma;
  const auto rows = recorded(pair_case(
      folder, {"particles=[{ids = [0], force = [1e-4, 0, 0]}, {ids = [1], force = [-1e-4, 0, 0]}]"}));
  EXPECT_NEAR(rows.column("neck_ratio_mean").back(),
              free_neck(0.05, (1.0 + load / attraction) * 60.0 / time_scale), 2e-6);
}

TEST(KnownAnswers, ChainWithItsRealMassForAnyFixedStep) {
  const io::TemporaryFolder folder;
  for (const std::string step : {"1e-8", "1e-4", "1", "60"}) {
    std::string chain = "x,y,z,radius\n";
    for (int n = 0; n < 8; ++n) chain += fmt::format("{},0,0,5e-6\n", n * 1e-5);
    const double stop = std::min(60.0, 20.0 * std::stod(step));
    const auto whole = pair_case(folder, {"method.time_step=" + step, fmt::format("stop.time={}", stop)});
    folder.write("packing.csv", chain);
    const auto rows = recorded(whole);
    const double x = free_neck(0.05, stop / time_scale);
    for (std::size_t k = 0; k < rows.last.contacts.size(); ++k) {
      const double neck = std::sqrt(rows.last.contacts.neck_radius_squared[k]) / samples::radius;
      EXPECT_NEAR(neck, x, 1e-4 * x) << step << " contact " << k;
    }
  }
}

TEST(KnownAnswers, SimpleCubicLatticeReachesItsDensitiesInTime) {
  const io::TemporaryFolder folder;
  for (const auto& [density, tau] : {std::pair{0.7, 9.304e-4}, {0.8, 2.711e-3}, {0.9, 5.343e-3}}) {
    const auto rows = recorded(periodic_case(folder, "simple-cubic", 27,
                                             {"contact.initial_neck_ratio=1e-3", "method.accuracy=1e-3",
                                              fmt::format("stop.relative_density={}", density)}));
    EXPECT_NEAR(rows.column("time [s]").back() / time_scale / tau, 1.0, 1e-3) << density;
  }
}

class Lattices : public testing::TestWithParam<std::pair<const char*, double>> {};

TEST_P(Lattices, DensityFollowsTheNeck) {
  const io::TemporaryFolder folder;
  const auto& [name, first] = GetParam();
  const auto rows = recorded(
      periodic_case(folder, name, 108, {"contact.initial_neck_ratio=0.02", "stop.relative_density=0.8"}));
  const auto density = rows.column("relative_density"), neck = rows.column("neck_ratio_mean");
  // Approach (r^2 - r0^2)/(2R) of two radii.
  for (std::size_t n = 0; n < density.size(); ++n) {
    const double shrunk = 1.0 - (neck[n] * neck[n] - neck[0] * neck[0]) / 4.0;
    EXPECT_NEAR(density[n], first * std::pow(shrunk, -3), 1e-9) << neck[n];
  }
  EXPECT_NEAR(rows.column("linear_strain_x").back(), rows.column("linear_strain_z").back(), 1e-6);
}
INSTANTIATE_TEST_SUITE_P(Cubic, Lattices,
                         testing::Values(std::pair{"simple-cubic", pi / 6.0},
                                         std::pair{"body-centred-cubic", pi* std::sqrt(3.0) / 8.0},
                                         std::pair{"face-centred-cubic", pi / (3.0 * std::sqrt(2.0))}));

TEST(KnownAnswers, MeanFieldKeepsEveryParticleAtItsShareOfTheCell) {
  const io::TemporaryFolder folder;
  const auto largest_shift = [&](const std::string& method) {
    const auto rows = recorded(
        periodic_case(folder, "random-dense", 150, {"method.name=" + method, "stop.relative_density=0.7"}));
    double largest = 0.0;
    for (std::size_t n = 0; n < rows.first.particles.size(); ++n) {
      const Vec3 share = rows.first.particles.position[n].cwiseQuotient(rows.first.cell.size);
      const Vec3 now = rows.last.particles.position[n].cwiseQuotient(rows.last.cell.size);
      largest = std::max(largest, (now - share).cwiseAbs().maxCoeff());
    }
    return largest;
  };
  EXPECT_LT(largest_shift("mean-field"), 1e-12);
  EXPECT_GT(largest_shift("contact-dynamics"), 1e-3);
}

}  // namespace
}  // namespace frit::run
