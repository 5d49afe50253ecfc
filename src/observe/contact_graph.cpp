#include "observe/contact_graph.hpp"

#include <algorithm>

#include "core/parallel.hpp"
#include "observe/statistics.hpp"

namespace frit::observe {
namespace {

constexpr std::size_t most_sources = 64;

// Ordered pairs of neighbours of a particle that touch each other.
std::size_t linked_pairs(const ContactGraph& graph, std::size_t row) {
  std::size_t linked = 0;
  const auto own = graph.of(row);
  for (const std::int32_t other : own) {
    const auto theirs = graph.of(other);
    auto mine = own.begin();
    for (const std::int32_t third : theirs) {
      mine = std::lower_bound(mine, own.end(), third);
      if (mine == own.end()) break;
      linked += *mine == third ? 1 : 0;
    }
  }
  return linked;
}

double ordered_pairs(std::size_t count) {
  return static_cast<double>(count) * (static_cast<double>(count) - 1.0);
}

// Number of contacts on the shortest way to each particle; -1: there is none.
std::vector<std::int32_t> distances_from(const ContactGraph& graph, std::int32_t source) {
  std::vector<std::int32_t> distance(graph.size(), -1), queue{source};
  distance[source] = 0;
  for (std::size_t next = 0; next < queue.size(); ++next) {
    const std::int32_t row = queue[next];
    for (const std::int32_t other : graph.of(row)) {
      if (distance[other] >= 0) continue;
      distance[other] = distance[row] + 1;
      queue.push_back(other);
    }
  }
  return distance;
}

std::vector<std::int32_t> largest_cluster(const ContactGraph& graph) {
  const std::vector<std::int32_t> cluster = clusters_of(graph);
  std::vector<std::size_t> members;
  for (const std::int32_t number : cluster) {
    members.resize(std::max(members.size(), static_cast<std::size_t>(number) + 1));
    ++members[number];
  }
  std::vector<std::int32_t> rows;
  if (members.empty()) return rows;
  const auto largest = std::max_element(members.begin(), members.end()) - members.begin();
  for (std::size_t row = 0; row < cluster.size(); ++row) {
    if (cluster[row] == largest) rows.push_back(static_cast<std::int32_t>(row));
  }
  return rows;
}

}  // namespace

ContactGraph::ContactGraph(std::size_t particles, const PairSpans& pairs) {
  const NeighbourLists lists(particles, pairs);
  for (std::size_t row = 0; row < lists.particles(); ++row) {
    for (const Neighbour& other : lists.of(row)) {
      const bool known = entries_.size() > start_.back() && entries_.back() == other.row;
      if (!known && other.row != static_cast<std::int32_t>(row)) entries_.push_back(other.row);
    }
    start_.push_back(entries_.size());
  }
}

std::vector<double> clustering_coefficients(const ContactGraph& graph) {
  std::vector<double> coefficients(graph.size(), no_value);
  parallel_for(graph.size(), [&](std::size_t row) {
    const std::size_t count = graph.of(row).size();
    if (count < 2) return;
    coefficients[row] = static_cast<double>(linked_pairs(graph, row)) / ordered_pairs(count);
  });
  return coefficients;
}

double transitivity(const ContactGraph& graph) {
  double linked = 0.0, pairs = 0.0;
  for (std::size_t row = 0; row < graph.size(); ++row) {
    linked += static_cast<double>(linked_pairs(graph, row));
    pairs += ordered_pairs(graph.of(row).size());
  }
  return pairs > 0.0 ? linked / pairs : no_value;
}

std::vector<std::int32_t> clusters_of(const ContactGraph& graph) {
  std::vector<std::int32_t> cluster(graph.size(), -1);
  std::int32_t count = 0;
  for (std::size_t first = 0; first < graph.size(); ++first) {
    if (cluster[first] >= 0) continue;
    std::vector<std::int32_t> waiting{static_cast<std::int32_t>(first)};
    cluster[first] = count;
    while (!waiting.empty()) {
      const std::int32_t row = waiting.back();
      waiting.pop_back();
      for (const std::int32_t other : graph.of(row)) {
        if (cluster[other] >= 0) continue;
        cluster[other] = count;
        waiting.push_back(other);
      }
    }
    ++count;
  }
  return cluster;
}

double characteristic_path_length(const ContactGraph& graph) {
  const std::vector<std::int32_t> rows = largest_cluster(graph);
  if (rows.size() < 2) return no_value;
  const std::size_t sources = std::min(rows.size(), most_sources);
  double sum = 0.0;
  for (std::size_t n = 0; n < sources; ++n) {
    const auto distance = distances_from(graph, rows[n * rows.size() / sources]);
    for (const std::int32_t row : rows) sum += distance[row];
  }
  return sum / (static_cast<double>(sources) * static_cast<double>(rows.size() - 1));
}

}  // namespace frit::observe
