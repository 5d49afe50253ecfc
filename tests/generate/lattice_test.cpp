#include "generate/lattice.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <string>
#include <tuple>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "generate/packing_statistics.hpp"

namespace frit::generate {
namespace {

struct Known {
  LatticeKind kind;
  int per_cell;
  double coordination;
  double relative_density;
};

const Known all_known[] = {
    {LatticeKind::simple_cubic, 1, 6.0, pi / 6.0},
    {LatticeKind::body_centred_cubic, 2, 8.0, pi* std::numbers::sqrt3 / 8.0},
    {LatticeKind::face_centred_cubic, 4, 12.0, pi* std::numbers::sqrt2 / 6.0},
};

TEST(Lattice, HasTheExactDensityAndCoordinationAtAnySize) {
  for (const Known& known : all_known) {
    for (const int along : {1, 2, 5}) {
      const Packing lattice =
          make_lattice(known.kind, 5e-6, known.per_cell * along * along * along, Boundary::periodic);
      const PackingStatistics statistics = measure_packing(lattice.particles, lattice.cell);
      EXPECT_NEAR(statistics.relative_density, known.relative_density, 1e-13);
      EXPECT_EQ(statistics.coordination, known.coordination) << "along " << along;
      EXPECT_LT(statistics.overlap_largest, 1e-14);
      EXPECT_EQ(statistics.rattlers, 0.0);
    }
  }
}

TEST(Lattice, TakesTheLargestCubeNotAboveTheCount) {
  const auto count = [](LatticeKind kind, std::int64_t largest) {
    return make_lattice(kind, 1.0, largest, Boundary::periodic).particles.size();
  };
  EXPECT_EQ(count(LatticeKind::simple_cubic, 26), 8u);
  EXPECT_EQ(count(LatticeKind::simple_cubic, 27), 27u);
  EXPECT_EQ(count(LatticeKind::simple_cubic, 28), 27u);
  EXPECT_EQ(count(LatticeKind::body_centred_cubic, 249), 128u);
  EXPECT_EQ(count(LatticeKind::body_centred_cubic, 250), 250u);
  EXPECT_EQ(count(LatticeKind::face_centred_cubic, 4000), 4000u);
  EXPECT_EQ(count(LatticeKind::face_centred_cubic, 3999), 2916u);
}

TEST(Lattice, HasAtLeastOneUnitCell) {
  for (const Known& known : all_known) {
    EXPECT_EQ(make_lattice(known.kind, 1.0, 1, Boundary::free).particles.size(),
              static_cast<std::size_t>(known.per_cell));
  }
}

TEST(Lattice, FreeBlockIsThePeriodicOneInEmptySpace) {
  const Packing periodic = make_lattice(LatticeKind::body_centred_cubic, 2.0, 54, Boundary::periodic);
  const Packing block = make_lattice(LatticeKind::body_centred_cubic, 2.0, 54, Boundary::free);
  EXPECT_EQ(block.particles.position, periodic.particles.position);
  EXPECT_EQ(block.particles.id, periodic.particles.id);
  EXPECT_FALSE(block.cell.periodic);
  // A cube of n^3 cells: each centre sphere touches the corners there are.
  EXPECT_LT(measure_packing(block.particles, block.cell).coordination, 8.0);
}

TEST(Lattice, NamesEveryFaultAtOnce) {
  try {
    make_lattice(LatticeKind::simple_cubic, -1.0, 0, Boundary::periodic);
    FAIL() << "accepted";
  } catch (const InputError& error) {
    ASSERT_EQ(error.faults().size(), 2u);
    EXPECT_NE(error.faults()[0].find("radius: -1"), std::string::npos);
    EXPECT_NE(error.faults()[1].find("count: 0"), std::string::npos);
  }
}

}  // namespace
}  // namespace frit::generate
