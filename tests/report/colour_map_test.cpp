#include "report/colour_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/vec.hpp"

namespace frit::report {
namespace {

double linear(double part) { return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4); }

// L*a*b* of sRGB, D65, the way that the tables do not go.
Vec3 lab_of(const Rgb& rgb) {
  const double r = linear(rgb[0] / 255.0), g = linear(rgb[1] / 255.0), b = linear(rgb[2] / 255.0);
  const auto f = [](double t) {
    return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0;
  };
  const double x = f((0.4124564 * r + 0.3575761 * g + 0.1804375 * b) / 0.95047);
  const double y = f(0.2126729 * r + 0.7151522 * g + 0.0721750 * b);
  const double z = f((0.0193339 * r + 0.1191920 * g + 0.9503041 * b) / 1.08883);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

TEST(ColourMaps, LightnessGrowsEvenly) {
  for (const ColourMap& map : colour_maps()) {
    const double dark = lab_of(map.table.front()).x(), light = lab_of(map.table.back()).x();
    EXPECT_GT(light - dark, 70.0) << map.name;
    for (std::size_t n = 0; n < 256; ++n) {
      const double expected = dark + (light - dark) * static_cast<double>(n) / 255.0;
      EXPECT_NEAR(lab_of(map.table[n]).x(), expected, 1.0) << map.name << " " << n;
    }
  }
}

// Over a sixteenth of the map, so that rounding to whole numbers does not count.
TEST(ColourMaps, EqualStepsDifferEqually) {
  const ColourTable& table = colour_maps().front().table;
  double least = 1e9, most = 0.0;
  for (std::size_t n = 0; n + 16 < 256; ++n) {
    const double difference = (lab_of(table[n + 16]) - lab_of(table[n])).norm();
    least = std::min(least, difference);
    most = std::max(most, difference);
  }
  EXPECT_LT(most / least, 1.5);
}

}  // namespace
}  // namespace frit::report
