#include "solve/fronts.hpp"

#include <algorithm>
#include <numeric>

namespace frit::solve {
namespace {

class TreeBuilder {
 public:
  TreeBuilder(const Dissection& dissection, const Adjacency& graph)
      : graph_(graph),
        rank_(dissection.order.size()),
        front_of_(dissection.order.size()),
        seen_by_(dissection.order.size(), -1),
        number_(dissection.order.size(), 0),
        offspring_(dissection.first.size() - 1) {
    tree_.order = dissection.order;
    tree_.first = dissection.first;
    for (std::size_t rank = 0; rank < rank_.size(); ++rank)
      rank_[tree_.order[rank]] = static_cast<std::int32_t>(rank);
    for (std::int32_t front = 0; front < tree_.fronts(); ++front) {
      std::fill(front_of_.begin() + tree_.first[front], front_of_.begin() + tree_.first[front + 1], front);
    }
  }

  FrontTree build(std::span<const std::array<std::int32_t, 2>> links) {
    sort_links(links);
    tree_.boundary_start.assign(1, 0);
    for (std::int32_t front = 0; front < tree_.fronts(); ++front) {
      find_boundary(front);
      number_bodies(front);
      place_children(front);
      place_links(front, links);
    }
    tree_.child_start.assign(1, 0);
    for (const auto& children : offspring_) {
      tree_.children.insert(tree_.children.end(), children.begin(), children.end());
      tree_.child_start.push_back(tree_.children.size());
    }
    return std::move(tree_);
  }

 private:
  // A link belongs to the front that eliminates the first of its bodies.
  void sort_links(std::span<const std::array<std::int32_t, 2>> links) {
    tree_.entry_start.assign(static_cast<std::size_t>(tree_.fronts()) + 1, 0);
    const auto owner = [&](const std::array<std::int32_t, 2>& link) {
      return static_cast<std::size_t>(front_of_[std::min(rank_[link[0]], rank_[link[1]])]);
    };
    for (const auto& link : links) ++tree_.entry_start[owner(link) + 1];
    std::partial_sum(tree_.entry_start.begin(), tree_.entry_start.end(), tree_.entry_start.begin());
    std::vector<std::size_t> next(tree_.entry_start.begin(), tree_.entry_start.end() - 1);
    tree_.entries.resize(links.size());
    for (std::size_t k = 0; k < links.size(); ++k) {
      tree_.entries[next[owner(links[k])]++].link = static_cast<std::int32_t>(k);
    }
  }

  void find_boundary(std::int32_t front) {
    const std::int32_t end = tree_.first[front + 1];
    const std::size_t start = tree_.boundary.size();
    const auto meet = [&](std::int32_t rank) {
      if (rank < end || seen_by_[rank] == front) return;
      seen_by_[rank] = front;
      tree_.boundary.push_back(rank);
    };
    for (std::int32_t rank = tree_.first[front]; rank < end; ++rank) {
      for (const std::int32_t other : graph_.at(tree_.order[rank])) meet(rank_[other]);
    }
    for (const std::int32_t child : offspring_[front]) {
      for (std::size_t n = tree_.boundary_start[child]; n < tree_.boundary_start[child + 1]; ++n) {
        meet(tree_.boundary[n]);
      }
    }
    tree_.boundary_start.push_back(tree_.boundary.size());
    std::sort(tree_.boundary.begin() + static_cast<std::ptrdiff_t>(start), tree_.boundary.end());
    if (start == tree_.boundary.size()) {
      tree_.roots.push_back(front);
    } else {
      offspring_[front_of_[tree_.boundary[start]]].push_back(front);
    }
  }

  void number_bodies(std::int32_t front) {
    std::int32_t number = 0;
    for (std::int32_t rank = tree_.first[front]; rank < tree_.first[front + 1]; ++rank)
      number_[rank] = number++;
    for (const std::int32_t rank : tree_.boundary_of(front)) number_[rank] = number++;
    tree_.place_in_parent.resize(tree_.boundary.size(), -1);
  }

  void place_children(std::int32_t front) {
    for (const std::int32_t child : offspring_[front]) {
      for (std::size_t n = tree_.boundary_start[child]; n < tree_.boundary_start[child + 1]; ++n) {
        tree_.place_in_parent[n] = number_[tree_.boundary[n]];
      }
    }
  }

  void place_links(std::int32_t front, std::span<const std::array<std::int32_t, 2>> links) {
    for (std::size_t n = tree_.entry_start[front]; n < tree_.entry_start[front + 1]; ++n) {
      FrontEntry& entry = tree_.entries[n];
      const auto& [i, j] = links[entry.link];
      entry.is_turned = rank_[i] < rank_[j];
      entry.row = number_[std::max(rank_[i], rank_[j])];
      entry.column = number_[std::min(rank_[i], rank_[j])];
    }
  }

  const Adjacency& graph_;
  FrontTree tree_;
  std::vector<std::int32_t> rank_, front_of_, seen_by_, number_;
  std::vector<std::vector<std::int32_t>> offspring_;
};

}  // namespace

FrontTree front_tree(const Dissection& dissection, const Adjacency& graph,
                     std::span<const std::array<std::int32_t, 2>> links) {
  return TreeBuilder(dissection, graph).build(links);
}

}  // namespace frit::solve
