#include "generate/packing_statistics.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/constants.hpp"
#include "generate/lattice.hpp"

namespace frit::generate {
namespace {

TEST(MeasurePacking, TwoSpheresGiveTheirOverlapAndCobleNeck) {
  Particles particles;
  particles.add({0, 0, 0}, 1.0);
  particles.add({0, 0, 2.9}, 2.0);
  particles.add({9, 9, 9}, 3.0);
  const PackingStatistics statistics = measure_packing(particles, {});
  const double equivalent = 4.0 / 3.0;
  EXPECT_EQ(statistics.count, 3u);
  EXPECT_EQ(statistics.contacts, 1u);
  EXPECT_NEAR(statistics.coordination, 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(statistics.rattlers, 1.0 / 3.0, 1e-15);
  EXPECT_NEAR(statistics.overlap_mean, 0.1 / equivalent, 1e-14);
  EXPECT_NEAR(statistics.overlap_largest, 0.1 / equivalent, 1e-14);
  EXPECT_NEAR(statistics.neck_ratio_mean, std::sqrt(2.0 * 0.1 * equivalent) / equivalent, 1e-13);
  EXPECT_EQ(statistics.radius_mean, 2.0);
  EXPECT_NEAR(statistics.radius_deviation, std::sqrt(2.0 / 3.0), 1e-15);
  EXPECT_EQ(statistics.radius_smallest, 1.0);
  EXPECT_EQ(statistics.radius_largest, 3.0);
}

TEST(MeasurePacking, TouchingCountsUpToABillionthOfTheRadius) {
  const auto contacts = [](double gap) {
    Particles particles;
    particles.add({0, 0, 0}, 1.0);
    particles.add({2.0 + gap, 0, 0}, 1.0);
    return measure_packing(particles, {}).contacts;
  };
  EXPECT_EQ(contacts(0.9e-9), 1u);
  EXPECT_EQ(contacts(1.1e-9), 0u);
}

TEST(MeasurePacking, NothingGivesZeros) {
  const PackingStatistics statistics = measure_packing({}, {});
  EXPECT_EQ(statistics.count, 0u);
  EXPECT_EQ(statistics.coordination, 0.0);
}

TEST(MeasurePacking, SmallFreeBodyHasNoDensityAndSaysSo) {
  const Packing block = make_lattice(LatticeKind::simple_cubic, 1.0, 8, Boundary::free);
  const PackingStatistics statistics = measure_packing(block.particles, block.cell);
  EXPECT_TRUE(std::isnan(statistics.relative_density));
  EXPECT_NE(to_text(statistics).find("unknown"), std::string::npos);
}

TEST(MeasurePacking, CoreOfALargeBlockHasNearlyTheLatticeDensity) {
  const Packing block = make_lattice(LatticeKind::face_centred_cubic, 1.0, 32000, Boundary::free);
  EXPECT_NEAR(measure_packing(block.particles, block.cell).relative_density, pi * std::sqrt(2.0) / 6.0, 0.02);
}

TEST(MeasurePacking, TextHoldsEveryFigure) {
  const Packing lattice = make_lattice(LatticeKind::simple_cubic, 5e-6, 27, Boundary::periodic);
  const std::string text = to_text(measure_packing(lattice.particles, lattice.cell));
  for (const char* part : {"27\n", "5e-06 m", "0.5236", "81\n", "6.000", "overlap / R", "neck ratio"}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in\n" << text;
  }
}

}  // namespace
}  // namespace frit::generate
