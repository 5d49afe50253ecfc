// The same results for any number of threads, and for any order of the input.
#include <gtest/gtest.h>

#include <cstring>
#include <numeric>
#include <random>

#include "core/parallel.hpp"
#include "generate/random_dense.hpp"
#include "io/packing_csv.hpp"
#include "run/id_order.hpp"
#include "run/samples.hpp"

namespace frit::run {
namespace {

using samples::periodic_case;
using samples::Recorder;

Recorder recorded(const config::Case& whole, int thread_count) {
  Recorder recorder;
  set_threads(thread_count);
  run_case(whole, {&recorder});
  set_threads(1);
  return recorder;
}

std::vector<std::uint64_t> bits_of(const Recorder& recorder) {
  std::vector<std::uint64_t> bits;
  const auto add = [&](double value) {
    bits.emplace_back();
    std::memcpy(&bits.back(), &value, sizeof(value));
  };
  for (const auto& row : recorder.rows) {
    for (const auto& column : row) add(column.value);
  }
  for (const Vec3& x : recorder.last.particles.position) {
    for (const double value : x) add(value);
  }
  return bits;
}

TEST(SameResults, OneAndTwoThreadsGiveTheSameBits) {
  const io::TemporaryFolder folder;
  const auto whole =
      periodic_case(folder, "random-dense", 500, {"packing.radius_spread=0.1", "stop.relative_density=0.68"});
  EXPECT_EQ(bits_of(recorded(whole, 1)), bits_of(recorded(whole, 2)));
}

TEST(SameResults, ARunRepeatsItself) {
  const io::TemporaryFolder folder;
  const auto whole = periodic_case(folder, "random-dense", 100, {"stop.relative_density=0.7"});
  EXPECT_EQ(bits_of(recorded(whole, 1)), bits_of(recorded(whole, 1)));
}

// The particles of a packing under other row numbers: the motion of each is the same to the last bit, because
// the internal order comes from the positions.
TEST(SameResults, TheOrderOfTheRowsDoesNotMatter) {
  const io::TemporaryFolder folder;
  const generate::Packing packing =
      generate::make_random_dense({.count = 500, .mean_radius = 5e-6, .relative_spread = 0.1});
  std::vector<std::size_t> row(packing.particles.size());
  std::iota(row.begin(), row.end(), 0u);
  const auto run_in_order = [&] {
    io::PackingTable table;
    for (const std::size_t n : row) {
      table.ids.push_back(static_cast<std::int64_t>(table.ids.size()));
      table.positions.push_back(packing.particles.position[n]);
      table.radii.push_back(packing.particles.radius[n]);
    }
    io::write_packing_csv(folder / "packing.csv", table);
    const Vec3& size = packing.cell.size;
    return recorded(samples::read_case(
                        folder, fmt::format("[packing]\nfile = \"packing.csv\"\n[cell]\nkind = \"periodic\"\n"
                                            "size = [{}, {}, {}]\n[material]\nuse = \"copper\"\n"
                                            "[stop]\nrelative_density = 0.68\n",
                                            size.x(), size.y(), size.z())),
                    1);
  };
  const Recorder straight = run_in_order();
  std::shuffle(row.begin(), row.end(), std::minstd_rand(11));
  const Recorder shuffled = run_in_order();
  EXPECT_EQ(straight.last.time, shuffled.last.time);
  const State a = in_id_order(straight.last), b = in_id_order(shuffled.last);
  for (std::size_t n = 0; n < row.size(); ++n)
    EXPECT_EQ(b.particles.position[n], a.particles.position[row[n]]);
}

TEST(SameResults, TheSolversAgree) {
  const io::TemporaryFolder folder;
  const auto last_time = [&](const std::string& solver) {
    const auto whole =
        periodic_case(folder, "simple-cubic", 27, {"method.solver=" + solver, "stop.relative_density=0.6"});
    return recorded(whole, 1).last.time;
  };
  EXPECT_NEAR(last_time("gauss-seidel") / last_time("conjugate-gradients"), 1.0, 1e-4);
}

}  // namespace
}  // namespace frit::run
