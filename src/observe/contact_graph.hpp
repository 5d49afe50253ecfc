// The contacts as a graph: how densely knit it is, how far its particles are apart. Definitions and sources:
// docs/observables.md.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "observe/neighbour_lists.hpp"
#include "state/state.hpp"

namespace frit::observe {

// Who touches whom, each particle once: several images of one neighbour are one, a particle's own copy is
// none.
class ContactGraph {
 public:
  // Rows of the pairs must lie in [0, particles).
  ContactGraph(std::size_t particles, const PairSpans& pairs);
  explicit ContactGraph(const State& state)
      : ContactGraph(state.particles.size(), {state.contacts.i, state.contacts.j, state.contacts.image}) {}

  std::size_t size() const { return start_.size() - 1; }
  // Rows of the particles that touch this one, ascending.
  std::span<const std::int32_t> of(std::size_t row) const {
    return std::span(entries_).subspan(start_[row], start_[row + 1] - start_[row]);
  }

 private:
  std::vector<std::size_t> start_{0};  // first entry of each particle, and the end
  std::vector<std::int32_t> entries_;
};

// Share of the pairs of a particle's neighbours that touch each other (Watts & Strogatz 1998), by rows;
// no_value with fewer than two neighbours.
std::vector<double> clustering_coefficients(const ContactGraph& graph);

// 3 triangles / connected triples of the whole graph; no_value without triples.
double transitivity(const ContactGraph& graph);

// The cluster of each particle: particles joined by chains of contacts have the same number, counted from 0
// in the order of their first rows.
std::vector<std::int32_t> clusters_of(const ContactGraph& graph);

// Mean number of contacts on the shortest way between two particles of the largest cluster: from at most 64
// of its particles, evenly spaced in the order of rows, to all others. no_value for a cluster of one.
double characteristic_path_length(const ContactGraph& graph);

}  // namespace frit::observe
