#include "solve/patch.hpp"

#include <algorithm>

#include "core/parallel.hpp"

namespace frit::solve {
namespace {

// Of all bodies: the most that count as few.
constexpr double largest_share = 1.0 / 300.0;

}  // namespace

PatchMaker::PatchMaker(const Problem& problem, const EdgeBlocks& blocks)
    : problem_(problem), incidence_(problem, blocks), place_(problem.bodies(), -1) {}

void PatchMaker::visit(std::uint32_t body, Patch& patch) {
  if (place_[body] >= 0) return;
  place_[body] = static_cast<std::int32_t>(patch.bodies.size());
  patch.bodies.push_back(body);
}

void PatchMaker::add_neighbours(std::size_t begin, Patch& patch) {
  const std::size_t end = patch.bodies.size();
  for (std::size_t n = begin; n < end; ++n) {
    for (const Incident incident : incidence_.at(patch.bodies[n])) {
      const Edge& edge = problem_.edges[incident.edge()];
      visit(static_cast<std::uint32_t>(incident.is_second() ? edge.i : edge.j), patch);
    }
  }
}

Patch PatchMaker::around(std::span<const std::uint32_t> seeds, int rings) {
  Patch patch;
  for (const std::uint32_t body : seeds) visit(body, patch);
  std::size_t begin = 0;
  for (int ring = 0; ring < rings; ++ring) {
    const std::size_t end = patch.bodies.size();
    add_neighbours(begin, patch);
    begin = end;
  }
  patch.active = patch.bodies.size();
  add_neighbours(begin, patch);
  copy_bodies(patch);
  copy_edges(patch);
  for (const std::uint32_t body : patch.bodies) place_[body] = -1;
  return patch;
}

void PatchMaker::copy_bodies(Patch& patch) const {
  Problem& part = patch.problem;
  for (std::size_t n = 0; n < patch.bodies.size(); ++n) {
    const std::uint32_t body = patch.bodies[n];
    part.mass.push_back(problem_.mass[body]);
    part.moment.push_back(problem_.moment[body]);
    part.load.push_back(problem_.load[body]);
    part.torque.push_back(problem_.torque[body]);
    if (!problem_.position.empty()) part.position.push_back(problem_.position[body]);
    if (!problem_.carried.empty()) part.carried.push_back(problem_.carried[body]);
    const bool is_free = n < patch.active;
    part.held.push_back(is_free ? problem_.held[body] : holds_translation | holds_rotation);
  }
  part.has_axes = problem_.has_axes;  // held, all three
  part.force_unit = problem_.force_unit;
}

void PatchMaker::copy_edges(Patch& patch) const {
  for (std::size_t n = 0; n < patch.active; ++n) {
    for (const Incident incident : incidence_.at(patch.bodies[n])) {
      Edge edge = problem_.edges[incident.edge()];
      edge.i = place_[static_cast<std::size_t>(edge.i)];
      edge.j = place_[static_cast<std::size_t>(edge.j)];
      // Between two free bodies: met at both, taken at the first.
      const bool taken_at_i = static_cast<std::size_t>(edge.i) < patch.active;
      if (incident.is_second() && taken_at_i) continue;
      patch.edges.push_back(incident.edge());
      patch.problem.edges.push_back(edge);
      if (problem_.has_axes) patch.problem.branch.push_back(problem_.branch[incident.edge()]);
    }
  }
}

Solution taken_from(const Solution& whole, const Patch& patch) {
  Solution part = Solution::at_rest(patch.problem);
  for (std::size_t n = 0; n < patch.bodies.size(); ++n) {
    std::copy_n(whole.motion.begin() + std::ptrdiff_t{6} * patch.bodies[n], 6, part.motion.begin() + 6 * n);
  }
  std::copy_n(whole.motion.end() - 3, 3, part.motion.end() - 3);
  for (std::size_t k = 0; k < patch.edges.size(); ++k) part.multiplier[k] = whole.multiplier[patch.edges[k]];
  return part;
}

void put_back(const Solution& part, const Patch& patch, Solution& whole) {
  for (std::size_t n = 0; n < patch.active; ++n) {
    std::copy_n(part.motion.begin() + 6 * n, 6, whole.motion.begin() + std::ptrdiff_t{6} * patch.bodies[n]);
  }
  for (std::size_t k = 0; k < patch.edges.size(); ++k) whole.multiplier[patch.edges[k]] = part.multiplier[k];
}

std::vector<std::uint32_t> unbalanced_few(std::span<const double> gradient, std::size_t bodies, Rest rest) {
  struct Body {
    double square;
    std::uint32_t index;
  };
  const double wanted = rest.wanted * rest.wanted, acceptable = rest.acceptable * rest.acceptable;
  const double negligible = wanted / static_cast<double>(std::max<std::size_t>(1, bodies));
  std::vector<double> squares(bodies);
  double left = ordered_sum(bodies, 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t n = begin; n < end; ++n) {
      double square = 0.0;
      for (const double value : gradient.subspan(6 * n, 6)) square += value * value;
      squares[n] = square;
      sum += square;
    }
    return sum;
  });
  std::vector<Body> worst;
  for (std::size_t n = 0; n < bodies; ++n) {
    if (squares[n] > negligible) worst.push_back({squares[n], static_cast<std::uint32_t>(n)});
  }
  const auto most =
      std::min(worst.size(), static_cast<std::size_t>(largest_share * static_cast<double>(bodies)));
  std::partial_sort(worst.begin(), worst.begin() + static_cast<std::ptrdiff_t>(most), worst.end(),
                    [](const Body& a, const Body& b) {
                      return a.square != b.square ? a.square > b.square : a.index < b.index;
                    });
  worst.resize(most);
  std::vector<std::uint32_t> few;
  for (const Body& body : worst) {
    if (left <= wanted) break;
    few.push_back(body.index);
    left -= body.square;
  }
  if (left > acceptable) few.clear();
  return few;
}

}  // namespace frit::solve
