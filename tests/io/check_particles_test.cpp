#include "io/check_particles.hpp"

#include <cmath>
#include <limits>
#include <random>
#include <set>

#include "temporary_folder.hpp"

namespace frit::io {
namespace {

struct Table {
  std::vector<std::int64_t> ids;
  std::vector<Vec3> positions;
  std::vector<double> radii;
};

std::vector<std::string> faults_in(const Table& table) {
  FaultList faults;
  check_particles(
      {table.ids, table.positions, table.radii, [](std::size_t row) { return std::to_string(row); }}, faults);
  return faults_of("folder/file", [&] { faults.throw_if_any(); });
}

// Few values, so that repeats are common; now and then NaN and negative zero.
Table random_table(std::mt19937& generator, std::size_t count) {
  const double values[] = {0.0, -0.0, 1.0, 2.0, std::numeric_limits<double>::quiet_NaN()};
  const auto pick = [&] { return values[generator() % 5]; };
  Table table;
  for (std::size_t row = 0; row < count; ++row) {
    table.ids.push_back(static_cast<std::int64_t>(generator() % 12));
    const double x = pick(), y = pick();
    table.positions.emplace_back(x, y, pick());
    table.radii.push_back(static_cast<double>(generator() % 4));
  }
  return table;
}

// "row: the first row of its kind" for each repeat, by comparing all pairs.
template <class Same>
std::set<std::string> repeats_by_pairs(std::size_t count, Same&& same) {
  std::set<std::string> repeats;
  for (std::size_t second = 0; second < count; ++second) {
    std::size_t first = 0;
    while (first < second && !same(first, second)) ++first;
    if (first < second) repeats.insert(std::to_string(second) + " repeats " + std::to_string(first));
  }
  return repeats;
}

// The same from the faults' texts that hold `kind`.
std::set<std::string> repeats_in(const std::vector<std::string>& faults, const std::string& kind) {
  std::set<std::string> repeats;
  for (const auto& fault : faults) {
    if (fault.find(kind) == fault.npos) continue;
    repeats.insert(fault.substr(0, fault.find(':')) + " repeats " + fault.substr(fault.rfind(' ') + 1));
  }
  return repeats;
}

TEST(CheckParticles, FindsTheRepeatsThatComparingAllPairsFinds) {
  std::mt19937 generator(5);
  for (int trial = 0; trial < 3000; ++trial) {
    const auto table = random_table(generator, 1 + generator() % 7);
    const auto faults = faults_in(table);
    const auto same_id = [&](auto a, auto b) { return table.ids[a] == table.ids[b]; };
    const auto same_centre = [&](auto a, auto b) { return table.positions[a] == table.positions[b]; };
    ASSERT_EQ(repeats_in(faults, "already the id"), repeats_by_pairs(table.ids.size(), same_id));
    ASSERT_EQ(repeats_in(faults, "already the centre"), repeats_by_pairs(table.ids.size(), same_centre));
    const auto bad_radii = std::ranges::count(table.radii, 0.0);
    ASSERT_EQ(bad_radii, std::ranges::count_if(
                             faults, [](const auto& fault) { return fault.find("radius") != fault.npos; }));
  }
}

TEST(CheckParticles, GoodParticlesHaveNoFaults) {
  EXPECT_TRUE(faults_in({{3, 1}, {{0, 0, 0}, {0, 0, 1}}, {1, 1}}).empty());
  EXPECT_TRUE(faults_in({}).empty());
}

TEST(FaultList, KeepsTheFirstTwentyAndCountsTheRest) {
  for (const int count : {0, 1, 20, 21, 1000}) {
    FaultList faults;
    for (int k = 0; k < count; ++k) faults.add("fault " + std::to_string(k));
    const auto shown = faults_of("folder/file", [&] { faults.throw_if_any(); });
    EXPECT_EQ(faults.empty(), count == 0);
    ASSERT_EQ(shown.size(), static_cast<std::size_t>(std::min(count, 21)));
    const auto last =
        count > 20 ? "and " + std::to_string(count - 20) + " more" : "fault " + std::to_string(count - 1);
    EXPECT_TRUE(shown.empty() || shown.back() == last) << shown.back();
  }
}

}  // namespace
}  // namespace frit::io
