#include "report/frame_packer.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "report/packing_data.hpp"

namespace frit::report {
namespace {

constexpr double edge = 2e-4;  // [m]

io::Frame frame_of(std::size_t count, unsigned seed, bool periodic) {
  std::mt19937 dice(seed);
  std::uniform_real_distribution<double> part(-0.4, 1.4);  // beyond the cell, as centres may be
  io::Frame frame;
  frame.cell = {periodic, Vec3::Constant(edge)};
  frame.origin = Vec3(1e-5, 0.0, -3e-5);
  for (std::size_t n = 0; n < count; ++n) {
    frame.ids.push_back(static_cast<std::int64_t>(n));
    frame.positions.push_back(frame.origin + edge * Vec3(part(dice), part(dice), part(dice)));
    frame.radii.push_back(5e-6 * (1.0 + 0.1 * static_cast<double>(n % 5)));
  }
  return frame;
}

// Reads places back the way web/src/frames.ts does.
class PlaceReader {
 public:
  explicit PlaceReader(std::size_t count) : last_(3 * count, 0), count_(count) {}
  std::vector<double> read(const Bytes& bytes, double steps) {
    std::vector<double> parts;
    for (std::size_t n = 0; n < 3 * count_; ++n) {
      const std::size_t axis = n / count_, row = n % count_;
      const std::size_t low = 2 * axis * count_ + row;
      last_[n] = static_cast<std::uint16_t>(last_[n] + (bytes[low] | bytes[low + count_] << 8));
      parts.push_back(last_[n] / steps);
    }
    return parts;
  }

 private:
  std::vector<std::uint16_t> last_;
  std::size_t count_;
};

TEST(FramePacker, PlacesReadBackToHalfAStepInAPeriodicCell) {
  FramePacker packer({}, 8e-6);
  PlaceReader reader(200);
  for (const unsigned seed : {1u, 2u, 3u}) {  // each builds on the one before
    const io::Frame frame = frame_of(200, seed, true);
    const auto parts = reader.read(packer.pack(frame, nullptr), 65536.0);
    for (std::size_t n = 0; n < parts.size(); ++n) {
      const int axis = static_cast<int>(n / 200);
      const double place = (frame.positions[n % 200][axis] - frame.origin[axis]) / edge;
      EXPECT_LE(std::abs(std::remainder(parts[n] - place, 1.0)), 0.5001 / 65536.0);
    }
  }
}

TEST(FramePacker, PlacesOfAFreeBodyReadBackInItsBox) {
  FramePacker packer({}, 8e-6);
  PlaceReader reader(50);
  const io::Frame frame = frame_of(50, 4, false);
  const FramePacker::Box box = FramePacker::box_of(frame);
  const auto parts = reader.read(packer.pack(frame, nullptr), 65535.0);
  for (std::size_t n = 0; n < parts.size(); ++n) {
    const int axis = static_cast<int>(n / 50);
    EXPECT_NEAR(box.origin[axis] + parts[n] * box.size[axis], frame.positions[n % 50][axis],
                0.51 * box.size[axis] / 65535.0);
  }
}

TEST(FieldScale, CodesReadBackToHalfAStep) {
  const FieldScale plain{"a", -2.0, 3.0, false}, square{"b", 0.0, 3.0, true};
  for (double value = 0.0; value <= 3.0; value += 0.01) {
    EXPECT_NEAR(-2.0 + 5.0 * plain.code_of(value) / 254.0, value, 0.5001 * 5.0 / 254.0);
    EXPECT_NEAR(square.code_of(value) / 254.0, std::sqrt(value / 3.0), 0.5001 / 254.0);
  }
  EXPECT_EQ(plain.code_of(std::nan("")), 255);
  EXPECT_EQ(plain.code_of(7.0), 254);
}

TEST(NecksOf, RowsInOrderWithoutOwnCopies) {
  io::PolyData network;
  network.cell_arrays = {{"i", 1, std::vector<std::int64_t>{30, 10, 10, 20}},
                         {"j", 1, std::vector<std::int64_t>{20, 20, 10, 99}},
                         {"neck_ratio", 1, std::vector<double>{0.3, 0.1, 0.5, 0.9}}};
  const NeckData necks = necks_of(network, {10, 20, 30});
  EXPECT_EQ(necks.i, (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(necks.j, (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(necks.ratio, (std::vector<double>{0.1, 0.3}));
}

TEST(ChooseEvenly, KeepsBothEndsAndEvenSteps) {
  for (std::size_t count = 1; count < 60; ++count) {
    for (std::size_t wanted = 2; wanted < 20; ++wanted) {
      const auto chosen = choose_evenly(count, wanted);
      ASSERT_EQ(chosen.size(), std::min(count, wanted));
      EXPECT_EQ(chosen.front(), 0u);
      EXPECT_EQ(chosen.back(), count - 1);
      for (std::size_t n = 1; n < chosen.size(); ++n) {
        const double step = static_cast<double>(count - 1) / static_cast<double>(chosen.size() - 1);
        EXPECT_LE(std::abs(static_cast<double>(chosen[n] - chosen[n - 1]) - step), 1.0);
        EXPECT_GT(chosen[n], chosen[n - 1]);
      }
    }
  }
}

}  // namespace
}  // namespace frit::report
