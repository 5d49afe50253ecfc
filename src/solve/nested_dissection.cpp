#include "solve/nested_dissection.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/contract.hpp"

namespace frit::solve {
namespace {

enum class Side : std::uint8_t { left, right, separator, elsewhere };

constexpr double largest_imbalance = 0.4;  // that smoothing may lead to; the figures hardly matter (measured)
constexpr double imbalance_price = 1.0;

struct Sizes {
  std::size_t left = 0, right = 0, separator = 0;
};

double imbalance(const Sizes& sizes) {
  const auto left = static_cast<double>(sizes.left), right = static_cast<double>(sizes.right);
  return std::abs(left - right) / std::max(1.0, left + right);
}

// What a cut costs: the separator, dearer when the halves differ.
double cost(const Sizes& sizes) {
  const double unequal = imbalance(sizes);
  return static_cast<double>(sizes.separator) * (1.0 + imbalance_price * unequal * unequal);
}

// Cuts one set of bodies after the other; keeps its marks between them.
class Cutter {
 public:
  Cutter(std::span<const Vec3> positions, const Adjacency& graph)
      : positions_(positions),
        graph_(graph),
        side_(positions.size(), Side::elsewhere),
        mate_(positions.size(), none),
        found_from_(positions.size(), none) {}

  // Side of every body of `bodies`.
  const std::vector<Side>& cut(std::span<const std::int32_t> bodies) {
    double least = -1.0;
    for (int axis = 0; axis < 3; ++axis) {
      halve(bodies, axis);
      Sizes sizes = separate(bodies);
      while (smooth(bodies, Side::right, sizes) || smooth(bodies, Side::left, sizes)) {
      }
      if (least >= 0.0 && cost(sizes) >= least) continue;
      least = cost(sizes);
      best_.clear();
      for (const std::int32_t body : bodies) best_.push_back(side_[body]);
    }
    for (const std::int32_t body : bodies) side_[body] = Side::elsewhere;
    return best_;
  }

 private:
  static constexpr std::int32_t none = -1;

  void halve(std::span<const std::int32_t> bodies, int axis) {
    along_.clear();
    for (const std::int32_t body : bodies) along_.emplace_back(positions_[body][axis], body);
    const auto middle = along_.begin() + static_cast<std::ptrdiff_t>(along_.size() / 2);
    std::nth_element(along_.begin(), middle, along_.end());
    for (auto at = along_.begin(); at != along_.end(); ++at) {
      side_[at->second] = at < middle ? Side::left : Side::right;
    }
  }

  // The bodies of the left half that touch the right one become the separator.
  Sizes separate(std::span<const std::int32_t> bodies) {
    Sizes sizes;
    for (const std::int32_t body : bodies) {
      if (side_[body] == Side::right) {
        ++sizes.right;
      } else if (touches(body, Side::right)) {
        side_[body] = Side::separator;
        ++sizes.separator;
      } else {
        ++sizes.left;
      }
    }
    return sizes;
  }

  bool touches(std::int32_t body, Side side) const {
    const auto others = graph_.at(body);
    return std::any_of(others.begin(), others.end(),
                       [&](std::int32_t other) { return side_[other] == side; });
  }

  // Smallest separator among those made of the present one and its neighbours in `half` (a minimum vertex
  // cover of the links between both, by Koenig's theorem). True when the cut has become cheaper.
  bool smooth(std::span<const std::int32_t> bodies, Side half, Sizes& sizes) {
    separator_.clear();
    for (const std::int32_t body : bodies) {
      if (side_[body] == Side::separator) separator_.push_back(body);
    }
    reached_.clear();
    released_.clear();
    match(half);
    Sizes next = sizes;
    auto& shrinking = half == Side::left ? next.left : next.right;
    auto& growing = half == Side::left ? next.right : next.left;
    shrinking -= reached_.size();
    growing += released_.size();
    next.separator += reached_.size() - released_.size();
    const bool is_better =
        cost(next) < cost(sizes) && imbalance(next) < std::max(largest_imbalance, imbalance(sizes));
    if (is_better) {
      sizes = next;
      for (const std::int32_t body : reached_) side_[body] = Side::separator;
      for (const std::int32_t body : released_) side_[body] = half == Side::left ? Side::right : Side::left;
    }
    return is_better;
  }

  // Largest matching between separator and `half`. Bodies found by the searches that fail are left in
  // released_ (of the separator) and reached_ (of the half).
  void match(Side half) {
    for (const std::int32_t body : separator_) {
      for (const std::int32_t other : graph_.at(body)) {
        if (side_[other] != half || mate_[other] != none) continue;
        mate_[body] = other;
        mate_[other] = body;
        break;
      }
    }
    for (const std::int32_t body : separator_) {
      if (mate_[body] == none) augment(body, half);
    }
    for (const std::int32_t body : separator_) {
      for (const std::int32_t other : graph_.at(body)) mate_[other] = found_from_[other] = none;
      mate_[body] = none;
    }
  }

  // Breadth-first search for an alternating path from an unmatched body of the separator to an unmatched
  // one of the half. What a failed search has seen no later search can use.
  void augment(std::int32_t start, Side half) {
    const std::size_t seen = reached_.size(), queued = released_.size();
    released_.push_back(start);
    for (std::size_t next = queued; next < released_.size(); ++next) {
      const std::int32_t body = released_[next];
      for (const std::int32_t other : graph_.at(body)) {
        if (side_[other] != half || found_from_[other] != none) continue;
        found_from_[other] = body;
        reached_.push_back(other);
        if (mate_[other] == none) {
          flip(other);
          for (std::size_t n = seen; n < reached_.size(); ++n) found_from_[reached_[n]] = none;
          reached_.resize(seen);
          released_.resize(queued);
          return;
        }
        released_.push_back(mate_[other]);
      }
    }
  }

  void flip(std::int32_t end) {
    while (end != none) {
      const std::int32_t body = found_from_[end];
      const std::int32_t next = mate_[body];
      mate_[end] = body;
      mate_[body] = end;
      end = next;
    }
  }

  std::span<const Vec3> positions_;
  const Adjacency& graph_;
  std::vector<Side> side_, best_;
  std::vector<std::int32_t> mate_, found_from_;
  std::vector<std::int32_t> separator_, released_, reached_;
  std::vector<std::pair<double, std::int32_t>> along_;
};

class Dissector {
 public:
  Dissector(std::span<const Vec3> positions, const Adjacency& graph, std::size_t leaf_bodies)
      : cutter_(positions, graph), leaf_bodies_(leaf_bodies) {
    result_.order.resize(positions.size());
    std::iota(result_.order.begin(), result_.order.end(), 0);
    result_.first.push_back(0);
  }

  Dissection run() {
    if (!result_.order.empty()) dissect(0, result_.order.size());
    return std::move(result_);
  }

 private:
  void dissect(std::size_t begin, std::size_t end) {
    const std::span bodies(result_.order.data() + begin, end - begin);
    if (bodies.size() <= leaf_bodies_) {
      result_.first.push_back(static_cast<std::int32_t>(end));
      return;
    }
    const std::vector<Side>& sides = cutter_.cut(bodies);
    std::array<std::vector<std::int32_t>, 3> pieces;
    for (std::size_t n = 0; n < bodies.size(); ++n) {
      pieces[static_cast<std::size_t>(sides[n])].push_back(bodies[n]);
    }
    auto next = bodies.begin();
    for (const auto& piece : pieces) next = std::copy(piece.begin(), piece.end(), next);
    const std::size_t left = pieces[0].size(), right = pieces[1].size();
    if (left > 0) dissect(begin, begin + left);
    if (right > 0) dissect(begin + left, begin + left + right);
    if (left + right < bodies.size()) result_.first.push_back(static_cast<std::int32_t>(end));
  }

  Cutter cutter_;
  std::size_t leaf_bodies_;
  Dissection result_;
};

}  // namespace

Adjacency adjacency(std::size_t bodies, std::span<const std::array<std::int32_t, 2>> links) {
  Adjacency graph;
  graph.first.assign(bodies + 1, 0);
  for (const auto& [i, j] : links) {
    FRIT_EXPECT(i != j && i >= 0 && j >= 0 && std::max(i, j) < static_cast<std::int32_t>(bodies));
    ++graph.first[static_cast<std::size_t>(i) + 1];
    ++graph.first[static_cast<std::size_t>(j) + 1];
  }
  std::partial_sum(graph.first.begin(), graph.first.end(), graph.first.begin());
  graph.others.resize(2 * links.size());
  std::vector<std::size_t> next(graph.first.begin(), graph.first.end() - 1);
  for (const auto& [i, j] : links) {
    graph.others[next[i]++] = j;
    graph.others[next[j]++] = i;
  }
  auto kept = graph.others.begin();
  for (std::size_t body = 0; body < bodies; ++body) {
    const auto begin = graph.others.begin() + static_cast<std::ptrdiff_t>(graph.first[body]);
    const auto end = graph.others.begin() + static_cast<std::ptrdiff_t>(graph.first[body + 1]);
    std::sort(begin, end);
    graph.first[body] = static_cast<std::size_t>(kept - graph.others.begin());
    kept = std::unique_copy(begin, end, kept);
  }
  graph.others.erase(kept, graph.others.end());
  graph.first[bodies] = graph.others.size();
  return graph;
}

Dissection dissect(std::span<const Vec3> positions, const Adjacency& graph, std::size_t leaf_bodies) {
  FRIT_EXPECT(leaf_bodies > 0 && graph.first.size() == positions.size() + 1);
  return Dissector(positions, graph, leaf_bodies).run();
}

}  // namespace frit::solve
