#include "report/sphere_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "core/parallel.hpp"

namespace frit::report {
namespace {

const PictureFrame frame{400, 300, 1.5, -2.0, 2.0};  // a pixel is 0.01

const Rgb& pixel(const Image& image, int column, int row) {
  return image.pixels[static_cast<std::size_t>(row * image.width + column)];
}

// How much of a pixel is not background: black balls are lit to black.
double cover(const Image& image) {
  double sum = 0.0;
  for (const Rgb& rgb : image.pixels) sum += 1.0 - rgb[0] / 255.0;
  return sum;
}

TEST(DrawBalls, ABallCoversItsDisc) {
  const PictureFrame no_haze{400, 300, 1.5, -2.0, 1e9};
  for (const double radius : {0.02, 0.113, 0.9}) {
    const Image image = draw_balls(std::vector<Ball>{{Vec3(0.213, -0.117, 0.4), radius, {0, 0, 0}}}, no_haze);
    const double area = std::numbers::pi * radius * radius / 1e-4;
    // Rays sample the rim: the error is that of counting lattice points near a circle.
    EXPECT_NEAR(cover(image), area, 0.02 * 2.0 * std::numbers::pi * radius / 0.01 + 0.05) << radius;
  }
}

TEST(DrawBalls, XIsRightYIsUp) {
  const Image image = draw_balls(std::vector<Ball>{{Vec3(1.5, 1.0, 0.0), 0.2, {0, 0, 0}}}, frame);
  EXPECT_LT(pixel(image, 350, 50)[0], 100);
  EXPECT_EQ(pixel(image, 50, 250), (Rgb{255, 255, 255}));
}

TEST(DrawBalls, TheNearerOneHidesWhateverTheOrder) {
  const Ball near{Vec3(0.0, 0.0, -1.0), 0.3, {255, 0, 0}}, far{Vec3(0.1, 0.0, 1.0), 0.5, {0, 255, 0}};
  const Image one = draw_balls(std::vector<Ball>{near, far}, frame),
              other = draw_balls(std::vector<Ball>{far, near}, frame);
  EXPECT_EQ(one.pixels, other.pixels);
  EXPECT_GT(pixel(one, 200, 150)[0], pixel(one, 200, 150)[1]);
  EXPECT_GT(pixel(one, 245, 150)[1], pixel(one, 245, 150)[0]);
}

// Two balls that pass through each other meet in the plane between them.
TEST(DrawBalls, BallsMeetInTheirPlane) {
  const Image image = draw_balls(
      std::vector<Ball>{{Vec3(-0.3, 0.0, 0.0), 0.5, {255, 0, 0}}, {Vec3(0.3, 0.0, 0.0), 0.5, {0, 255, 0}}},
      frame);
  for (int row = 120; row < 180; ++row) {
    EXPECT_GT(pixel(image, 197, row)[0], pixel(image, 197, row)[1]);
    EXPECT_GT(pixel(image, 202, row)[1], pixel(image, 202, row)[0]);
  }
}

TEST(DrawBalls, SameBytesForAnyNumberOfThreads) {
  std::mt19937 dice(9);
  std::uniform_real_distribution<double> place(-1.5, 1.5);
  std::vector<Ball> balls;
  for (int n = 0; n < 300; ++n)
    balls.push_back({Vec3(place(dice), place(dice), place(dice)), 0.15, {200, 90, 20}});
  const PictureFrame tall{200, 1200, 1.5, -2.0, 2.0};
  set_threads(1);
  const Image one = draw_balls(balls, tall);
  set_threads(3);
  EXPECT_EQ(draw_balls(balls, tall).pixels, one.pixels);
  set_threads(0);
}

}  // namespace
}  // namespace frit::report
