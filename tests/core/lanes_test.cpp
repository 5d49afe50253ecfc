#include "core/lanes.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "solve/dice.hpp"

namespace frit {
namespace {

using frit::testing::Dice;

template <class Real>
class LanesWith : public ::testing::Test {};
using Precisions = ::testing::Types<float, double>;
TYPED_TEST_SUITE(LanesWith, Precisions);

template <class Real>
Vec3 rounded(const Vec3& v) {
  return v.cast<Real>().template cast<double>();
}

TYPED_TEST(LanesWith, HoldAVectorAndAZero) {
  Dice dice(1);
  for (int draw = 0; draw < 100; ++draw) {
    const Vec3 v = dice.vector(1e3);
    const Lanes<TypeParam> held = lanes<TypeParam>(v);
    EXPECT_EQ(to_vec3(held), rounded<TypeParam>(v));
    EXPECT_EQ(held[3], TypeParam(0));
  }
}

TYPED_TEST(LanesWith, DotIsTheScalarProductInEveryLane) {
  Dice dice(2);
  const double digits = 4.0 * std::numeric_limits<TypeParam>::epsilon();
  for (int draw = 0; draw < 1000; ++draw) {
    const Vec3 a = dice.vector(10.0), b = dice.vector(0.1);
    const Lanes<TypeParam> product = dot(lanes<TypeParam>(a), lanes<TypeParam>(b));
    for (int lane = 0; lane < 4; ++lane) EXPECT_NEAR(product[lane], a.dot(b), digits * a.norm() * b.norm());
  }
}

TYPED_TEST(LanesWith, DotCountsTheFourthLane) {
  const Lanes<TypeParam> a{1, 2, 3, 4}, b{5, 6, 7, 8};
  EXPECT_EQ(dot(a, b)[0], TypeParam(70));
  EXPECT_EQ(dot(a, without_fourth<TypeParam>(b))[2], TypeParam(38));
}

TYPED_TEST(LanesWith, CrossIsTheVectorProductAndAZero) {
  Dice dice(3);
  const double digits = 4.0 * std::numeric_limits<TypeParam>::epsilon();
  for (int draw = 0; draw < 1000; ++draw) {
    const Vec3 a = dice.vector(10.0), b = dice.vector(0.1);
    const Lanes<TypeParam> product = cross(lanes<TypeParam>(a), lanes<TypeParam>(b));
    EXPECT_LT((to_vec3(product) - a.cross(b)).norm(), digits * a.norm() * b.norm());
    EXPECT_EQ(product[3], TypeParam(0));
  }
  const Vec3 x = Vec3::UnitX(), y = Vec3::UnitY();
  EXPECT_EQ(to_vec3(cross(lanes<TypeParam>(x), lanes<TypeParam>(y))), Vec3(Vec3::UnitZ()));
}

TYPED_TEST(LanesWith, AreLoadedFromAnywhereInMemory) {
  const TypeParam numbers[]{0, 1, 2, 3, 4, 5, 6};
  for (int start = 0; start < 4; ++start) {
    const Lanes<TypeParam> loaded = load(numbers + start);
    for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(loaded[lane], TypeParam(start + lane));
  }
}

TYPED_TEST(LanesWith, KeepTheirNumbersInDouble) {
  const Lanes<TypeParam> third{TypeParam(1) / 3, TypeParam(-2) / 3, TypeParam(1e-30), TypeParam(8)};
  const Lanes<double> wide = to_double(third);
  for (int lane = 0; lane < 4; ++lane) EXPECT_EQ(wide[lane], static_cast<double>(third[lane]));
  EXPECT_EQ(sum(Lanes<double>{1.0, 10.0, 100.0, 1000.0}), 1111.0);
}

}  // namespace
}  // namespace frit
