#include "generate/random_dense.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "core/abandoned.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "generate/packing_statistics.hpp"
#include "neighbor/neighbor.hpp"

namespace frit::generate {
namespace {

PackingStatistics measure(const Packing& packing) { return measure_packing(packing.particles, packing.cell); }

// Mean of n n^T over the contact normals: a third of the unit matrix when no direction is preferred.
Mat3 contact_fabric(const Packing& packing) {
  const Particles& particles = packing.particles;
  Mat3 sum = Mat3::Zero();
  const auto pairs = neighbor::find_pairs(particles, packing.cell, 0.0);
  for (const auto& pair : pairs) {
    const Vec3 n = packing.cell.separation(particles.position[pair.i], particles.position[pair.j], pair.image)
                       .normalized();
    sum += n * n.transpose();
  }
  return sum / static_cast<double>(pairs.size());
}

struct Wanted {
  double relative_density, relative_spread;
};

// One thread: small packings gain nothing by more, and lose much where processors are shared.
class RandomDense : public testing::TestWithParam<Wanted> {
 protected:
  void SetUp() override { set_threads(1); }
  void TearDown() override { set_threads(0); }
};

TEST_P(RandomDense, IsAnIsotropicNetworkOfSlightOverlapsAtTheExactDensity) {
  const Wanted wanted = GetParam();
  const Packing packing = make_random_dense({.count = 2000,
                                             .mean_radius = 5e-6,
                                             .relative_spread = wanted.relative_spread,
                                             .relative_density = wanted.relative_density});
  const PackingStatistics statistics = measure(packing);
  EXPECT_EQ(statistics.count, 2000u);
  EXPECT_NEAR(statistics.relative_density, wanted.relative_density, 1e-12);
  EXPECT_NEAR(statistics.radius_mean, 5e-6, 1e-18);
  EXPECT_NEAR(statistics.radius_deviation / 5e-6, wanted.relative_spread,
              0.06 * wanted.relative_spread + 1e-12);
  EXPECT_GE(statistics.coordination, 5.5);
  EXPECT_LE(statistics.coordination, 7.3);
  EXPECT_LE(statistics.rattlers, 0.03);
  EXPECT_LE(statistics.overlap_mean, 0.018);
  EXPECT_LE(statistics.overlap_largest, 0.09);
  EXPECT_LT((contact_fabric(packing) - Mat3::Identity() / 3.0).cwiseAbs().maxCoeff(), 0.02);
}

INSTANTIATE_TEST_SUITE_P(DensitiesAndSpreads, RandomDense,
                         testing::Values(Wanted{0.60, 0.1}, Wanted{0.63, 0.0}, Wanted{0.63, 0.1},
                                         Wanted{0.63, 0.3}, Wanted{0.64, 0.0}, Wanted{0.64, 0.1},
                                         Wanted{0.64, 0.3}, Wanted{0.65, 0.0}, Wanted{0.65, 0.1},
                                         Wanted{0.65, 0.3}, Wanted{0.66, 0.0}, Wanted{0.66, 0.1},
                                         Wanted{0.66, 0.3}));

TEST(RandomDenseSeed, SameSeedSamePackingOtherSeedOther) {
  const Packing first = make_random_dense({.count = 300, .relative_spread = 0.1, .seed = 4});
  const Packing again = make_random_dense({.count = 300, .relative_spread = 0.1, .seed = 4});
  const Packing other = make_random_dense({.count = 300, .relative_spread = 0.1, .seed = 5});
  EXPECT_EQ(first.particles.position, again.particles.position);
  EXPECT_EQ(first.particles.radius, again.particles.radius);
  EXPECT_NE(first.particles.position, other.particles.position);
  EXPECT_NE(first.particles.radius, other.particles.radius);
}

// Asked before every step of every relaxation: whichever answer is yes, there is no packing and no further
// question.
TEST(RandomDenseAbandon, IsAskedOftenAndObeyedAtOnce) {
  RandomDenseOptions options{.count = 100, .seed = 4};
  int asked = 0, most = std::numeric_limits<int>::max();
  options.abandon = [&] { return ++asked > most; };
  const Packing whole = make_random_dense(options);
  const int in_all = asked;
  EXPECT_GT(in_all, 100);
  EXPECT_EQ(whole.particles.position, make_random_dense({.count = 100, .seed = 4}).particles.position);
  for (most = 0; most < in_all; most += in_all / 5) {
    asked = 0;
    EXPECT_THROW(make_random_dense(options), Abandoned);
    EXPECT_EQ(asked, most + 1);
  }
}

TEST(RandomDenseThreads, GiveTheSameBits) {
  const RandomDenseOptions options{.count = 1100, .relative_spread = 0.3, .relative_density = 0.63};
  set_threads(1);
  const Packing one = make_random_dense(options);
  set_threads(2);
  const Packing two = make_random_dense(options);
  set_threads(0);
  EXPECT_EQ(one.particles.position, two.particles.position);
  EXPECT_EQ(one.particles.radius, two.particles.radius);
  EXPECT_EQ(one.cell.size, two.cell.size);
}

TEST(RandomDenseCell, HoldsEveryCentre) {
  const Packing packing = make_random_dense({.count = 500, .relative_spread = 0.3, .relative_density = 0.62});
  for (const Vec3& x : packing.particles.position) {
    EXPECT_TRUE((x.array() >= 0.0).all() && (x.array() <= packing.cell.size.array()).all()) << x.transpose();
  }
}

TEST(RandomDenseScale, MeanRadiusOnlyScales) {
  const Packing small = make_random_dense({.count = 200, .mean_radius = 1e-9});
  const Packing large = make_random_dense({.count = 200, .mean_radius = 1.0});
  for (std::size_t i = 0; i < 200; ++i) {
    EXPECT_LT((1e9 * small.particles.position[i] - large.particles.position[i]).norm(), 1e-12);
  }
}

TEST(RandomDenseBall, IsCentredOfExactCountAndRound) {
  const Packing ball = make_random_dense(
      {.count = 1500, .mean_radius = 2.0, .relative_spread = 0.1, .boundary = Boundary::free});
  ASSERT_EQ(ball.particles.size(), 1500u);
  EXPECT_FALSE(ball.cell.periodic);
  Vec3 moment = Vec3::Zero();
  double furthest = 0.0, solid = 0.0;
  for (std::size_t i = 0; i < 1500; ++i) {
    const double cube = std::pow(ball.particles.radius[i], 3);
    moment += cube * ball.particles.position[i];
    solid += cube;
    furthest = std::max(furthest, ball.particles.position[i].norm());
    EXPECT_EQ(ball.particles.id[i], static_cast<std::int64_t>(i));
  }
  EXPECT_LT((moment / solid).norm(), 1e-10);
  EXPECT_NEAR(solid / std::pow(furthest, 3), 0.64, 0.03);  // the centres fill a ball evenly
  const PackingStatistics statistics = measure(ball);
  EXPECT_NEAR(statistics.radius_mean, 2.0, 1e-12);
  EXPECT_GE(statistics.coordination, 5.0);
  EXPECT_FALSE(std::isnan(statistics.relative_density));
}

TEST(RandomDenseBall, MayBeAsSmallAsOneSphere) {
  for (const int count : {1, 2, 13}) {
    const Packing ball = make_random_dense({.count = count, .boundary = Boundary::free});
    EXPECT_EQ(ball.particles.size(), static_cast<std::size_t>(count));
  }
}

TEST(RandomDenseCell, MayHoldVeryFewSpheres) {
  for (const int count : {1, 2, 5, 20}) {
    const Packing packing = make_random_dense({.count = count, .relative_spread = 0.1});
    EXPECT_EQ(packing.particles.size(), static_cast<std::size_t>(count));
    EXPECT_NEAR(measure(packing).relative_density, 0.64, 1e-12);
  }
}

TEST(RandomDenseOptions, NamesEveryFaultAtOnce) {
  try {
    make_random_dense({.count = 0,
                       .mean_radius = std::numeric_limits<double>::quiet_NaN(),
                       .relative_spread = 1.0,
                       .relative_density = 0.74});
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 4u);
    EXPECT_NE(error.faults()[0].find("count: 0;"), std::string::npos);
    EXPECT_NE(error.faults()[1].find("radius: nan;"), std::string::npos);
    EXPECT_NE(error.faults()[2].find("radius_spread: 1;"), std::string::npos);
    EXPECT_NE(error.faults()[3].find("relative_density: 0.74;"), std::string::npos);
  }
}

}  // namespace
}  // namespace frit::generate
