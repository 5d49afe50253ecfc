#include "run/morton.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <vector>

#include "observe/samples.hpp"

namespace frit::run {
namespace {

Particles cloud(std::size_t count) {
  observe::samples::Random random(7);
  Particles particles;
  for (std::size_t n = 0; n < count; ++n)
    particles.add(random.vector(1e-4), 1e-6 * static_cast<double>(n + 1));
  return particles;
}

double path_length(const Particles& particles) {
  double length = 0.0;
  for (std::size_t n = 1; n < particles.size(); ++n)
    length += (particles.position[n] - particles.position[n - 1]).norm();
  return length;
}

TEST(Morton, OrderIsAPermutation) {
  const auto order = morton_order(cloud(1000));
  std::vector<std::int32_t> sorted = order, rows(1000);
  std::sort(sorted.begin(), sorted.end());
  std::iota(rows.begin(), rows.end(), 0);
  EXPECT_EQ(sorted, rows);
}

TEST(Morton, CornersOfACubeFollowTheCurve) {
  Particles particles;
  for (int corner = 7; corner >= 0; --corner)
    particles.add(Vec3(corner & 1, corner >> 1 & 1, corner >> 2 & 1), 0.1);
  const std::vector<std::int32_t> expected{7, 6, 5, 4, 3, 2, 1, 0};
  EXPECT_EQ(morton_order(particles), expected);
}

TEST(Morton, NeighboursOnTheCurveAreNearInSpace) {
  const Particles particles = cloud(2000);
  EXPECT_LT(path_length(reordered(particles, morton_order(particles))), 0.2 * path_length(particles));
}

TEST(Morton, TheOrderOfTheInputDoesNotMatter) {
  const Particles particles = cloud(300);
  std::vector<std::int32_t> backwards(300);
  std::iota(backwards.rbegin(), backwards.rend(), 0);
  const Particles other = reordered(particles, backwards);
  const Particles a = reordered(particles, morton_order(particles)),
                  b = reordered(other, morton_order(other));
  EXPECT_EQ(a.id, b.id);
  EXPECT_EQ(a.radius, b.radius);
}

TEST(Morton, EverythingMovesWithItsParticle) {
  Particles particles = cloud(50);
  for (std::size_t n = 0; n < 50; ++n) {
    const auto mark = static_cast<double>(n);
    particles.mass[n] = mark;
    particles.velocity[n] = particles.spin[n] = particles.force[n] = Vec3::Constant(mark);
    particles.orientation[n] = Quat(mark + 1.0, 0, 0, 0);
    particles.fixed[n] = static_cast<std::uint8_t>(n);
  }
  const Particles moved = reordered(particles, morton_order(particles));
  for (std::size_t n = 0; n < 50; ++n) {
    const auto mark = static_cast<double>(moved.id[n]);
    EXPECT_EQ(moved.position[n], particles.position[static_cast<std::size_t>(moved.id[n])]);
    EXPECT_EQ(moved.radius[n], 1e-6 * (mark + 1.0));
    EXPECT_EQ(moved.mass[n], mark);
    EXPECT_EQ(moved.velocity[n].x() + moved.spin[n].y() + moved.force[n].z(), 3.0 * mark);
    EXPECT_EQ(moved.orientation[n].w(), mark + 1.0);
    EXPECT_EQ(moved.fixed[n], static_cast<std::uint8_t>(mark));
  }
}

TEST(Morton, NoParticlesAndOneParticleHaveTheirOrder) {
  EXPECT_TRUE(morton_order(Particles{}).empty());
  EXPECT_EQ(morton_order(cloud(1)), std::vector<std::int32_t>{0});
}

}  // namespace
}  // namespace frit::run
