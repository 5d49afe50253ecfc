#include "observe/contact_graph.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "observe/samples.hpp"
#include "observe/statistics.hpp"

namespace frit::observe {
namespace {

// Particles far apart with the given contacts.
State with_contacts(std::size_t particles, const std::vector<std::pair<int, int>>& pairs) {
  State state;
  for (std::size_t n = 0; n < particles; ++n) state.particles.add(Vec3(static_cast<double>(n), 0, 0), 0.1);
  for (const auto& [i, j] : pairs) samples::add_contact(state, i, j);
  return state;
}

// Distances by repeated relaxation over all triples (Floyd & Warshall).
std::vector<std::vector<double>> all_distances(const State& state) {
  const std::size_t count = state.particles.size();
  std::vector<std::vector<double>> d(count,
                                     std::vector<double>(count, std::numeric_limits<double>::infinity()));
  for (std::size_t n = 0; n < count; ++n) d[n][n] = 0.0;
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    const std::int32_t i = state.contacts.i[k], j = state.contacts.j[k];
    if (i != j) d[i][j] = d[j][i] = 1.0;
  }
  for (std::size_t via = 0; via < count; ++via)
    for (std::size_t i = 0; i < count; ++i)
      for (std::size_t j = 0; j < count; ++j) d[i][j] = std::min(d[i][j], d[i][via] + d[via][j]);
  return d;
}

TEST(ContactGraph, CountsNeighboursOnceAndNoOwnCopies) {
  State state = with_contacts(3, {{0, 0}, {0, 1}, {0, 1}, {0, 2}});
  state.contacts.image[2] = samples::image_at(1, 0, 0);
  const ContactGraph graph(state);
  ASSERT_EQ(graph.of(0).size(), 2u);
  EXPECT_EQ(graph.of(0)[0], 1);
  EXPECT_EQ(graph.of(1).size(), 1u);
}

TEST(Clustering, OfATriangleWithATailByHand) {
  const ContactGraph graph(with_contacts(5, {{0, 1}, {0, 2}, {1, 2}, {2, 3}}));
  const std::vector<double> found = clustering_coefficients(graph);
  EXPECT_EQ(found[0], 1.0);
  EXPECT_DOUBLE_EQ(found[2], 1.0 / 3.0);
  EXPECT_TRUE(std::isnan(found[3]));  // one neighbour
  EXPECT_TRUE(std::isnan(found[4]));  // none
  EXPECT_DOUBLE_EQ(transitivity(graph), 3.0 / 5.0);
}

TEST(Clustering, AgreesWithLookingAtAllTriples) {
  const State state = samples::make_lattice({.edge = 4, .spacing = 1.3, .jitter = 0.3, .periodic = true});
  std::set<std::pair<int, int>> touching;
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    const int i = state.contacts.i[k], j = state.contacts.j[k];
    if (i != j) touching.insert({{i, j}, {j, i}});
  }
  const auto found = clustering_coefficients(ContactGraph(state));
  for (int i = 0; i < 64; ++i) {
    double pairs = 0.0, linked = 0.0;
    for (int j = 0; j < 64; ++j)
      for (int k = 0; k < j; ++k) {
        if (!touching.contains({i, j}) || !touching.contains({i, k})) continue;
        pairs += 1.0;
        linked += touching.contains({j, k}) ? 1.0 : 0.0;
      }
    ASSERT_GT(linked, 0.0);
    EXPECT_DOUBLE_EQ(found[i], linked / pairs) << i;
  }
}

TEST(Clusters, AreNumberedInTheOrderOfTheirFirstRows) {
  const ContactGraph graph(with_contacts(6, {{0, 3}, {1, 4}, {4, 5}}));
  EXPECT_EQ(clusters_of(graph), (std::vector<std::int32_t>{0, 1, 2, 0, 1, 1}));
}

TEST(PathLength, OfAChainByHand) {
  // Of 4 in a row: distances 1 (three pairs), 2 (two), 3 (one).
  const State state = with_contacts(7, {{0, 1}, {1, 2}, {2, 3}, {4, 5}});
  EXPECT_DOUBLE_EQ(characteristic_path_length(ContactGraph(state)), 10.0 / 6.0);
}

TEST(PathLength, OfASmallClusterIsTheMeanOverAllPairs) {
  const State state = samples::make_lattice({.edge = 4, .jitter = 0.04});
  const auto distances = all_distances(state);
  double sum = 0.0;
  for (const auto& row : distances)
    for (const double d : row) sum += d;
  ASSERT_TRUE(std::isfinite(sum));
  EXPECT_DOUBLE_EQ(characteristic_path_length(ContactGraph(state)), sum / (64.0 * 63.0));
}

TEST(PathLength, SampledOverALargeClusterIsNearThatOverAllPairs) {
  // A cubic lattice of n^3: 3 times the mean distance of two different places in a row, n (n^2 - 1)/(3 n^2)
  // each.
  const int n = 12;
  const State state = samples::make_lattice({.edge = n});
  const double count = n * n * n;
  const double exact = (n * n - 1.0) / n * count / (count - 1.0);
  EXPECT_NEAR(characteristic_path_length(ContactGraph(state)), exact, 0.03 * exact);
}

TEST(PathLength, HasNoValueWithoutContacts) {
  EXPECT_TRUE(std::isnan(characteristic_path_length(ContactGraph(with_contacts(3, {})))));
}

}  // namespace
}  // namespace frit::observe
