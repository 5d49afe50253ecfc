// The search: spheres are sorted into classes of radii, each with its own grid; a sphere looks into the grid
// of its own class and into those of the larger spheres. A pair of two classes is thus found once, by its
// smaller sphere, in about 27 grid cells whose width fits the larger one: the work per sphere does not depend
// on the ratio of radii.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "neighbor/class_grid.hpp"
#include "neighbor/reach.hpp"

namespace frit::neighbor {
namespace {

constexpr int most_classes = 24;  // each holds radii within a factor of two; the last also all smaller ones

struct RadiusClass {
  double largest_radius;  // [m]
  ClassGrid grid;
};

double largest_of(const std::vector<double>& values) {
  return values.empty() ? 0.0 : *std::max_element(values.begin(), values.end());
}

// Coarsest first; empty classes are left out.
std::vector<RadiusClass> make_classes(const Particles& particles, const Cell& cell, double reach,
                                      const std::vector<Place>& places) {
  const double largest = largest_of(particles.radius);
  std::vector<std::vector<Member>> members(most_classes);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const double radius = particles.radius[i];
    const double halvings = radius > 0.0 ? std::log2(largest / radius) : most_classes;
    const int number = static_cast<int>(std::min(halvings, most_classes - 1.0));
    members[number].push_back({places[i].folded, radius, static_cast<std::int32_t>(i)});
  }
  std::vector<RadiusClass> classes;
  for (const auto& in_class : members) {
    if (in_class.empty()) continue;
    double class_largest = 0.0;
    for (const Member& member : in_class) class_largest = std::max(class_largest, member.radius);
    const double edge = 2.0 * class_largest + std::max(reach, 0.0);
    classes.push_back({class_largest, ClassGrid(in_class, cell, edge > 0.0 ? edge : 1.0)});
  }
  return classes;
}

class Search {
 public:
  Search(const Particles& particles, const Cell& cell, double reach)
      : particles_(particles),
        cell_(cell),
        reach_(reach),
        places_(find_places(particles, cell)),
        classes_(make_classes(particles, cell, reach, places_)) {}

  // All pairs, in the fixed order of classes and blocks; a pair may come twice when buckets collide.
  std::vector<Pair> all_pairs() const {
    std::vector<Pair> pairs;
    for (std::size_t own = 0; own < classes_.size(); ++own) {
      const auto members = classes_[own].grid.members();
      std::vector<std::vector<Pair>> found((members.size() + block_size - 1) / block_size);
      parallel_blocks(members.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t m = begin; m < end; ++m) look_around(members[m], own, found[begin / block_size]);
      });
      for (const auto& block : found) pairs.insert(pairs.end(), block.begin(), block.end());
    }
    return pairs;
  }

 private:
  void look_around(const Member& i, std::size_t own, std::vector<Pair>& found) const {
    for (std::size_t other = 0; other <= own; ++other) look_into(i, classes_[other], other == own, found);
  }

  void look_into(const Member& i, const RadiusClass& other, bool same_class, std::vector<Pair>& found) const {
    const double limit = i.radius + other.largest_radius + reach_;
    if (limit < 0.0) return;
    const Vec3 margin = Vec3::Constant(limit + round_off(i));
    const auto low = other.grid.index_of(i.folded - margin);
    const auto high = other.grid.index_of(i.folded + margin);
    for (std::int64_t z = low[2]; z <= high[2]; ++z) {
      for (std::int64_t y = low[1]; y <= high[1]; ++y) {
        for (std::int64_t x = low[0]; x <= high[0]; ++x) {
          add_pairs(i, other.grid.bucket({x, y, z}), same_class, found);
        }
      }
    }
  }

  // What folding two positions into the cell, at most 127 edges away, and finding their grid cells may cost
  // [m].
  double round_off(const Member& i) const {
    const double furthest = cell_.periodic ? 128.0 * cell_.size.maxCoeff() : i.folded.cwiseAbs().maxCoeff();
    return 8.0 * std::numeric_limits<double>::epsilon() * (furthest + i.radius + std::abs(reach_));
  }

  void add_pairs(const Member& i, const ClassGrid::Bucket& bucket, bool same_class,
                 std::vector<Pair>& found) const {
    if (bucket.members.empty()) return;
    Vec3 x_i = i.folded;
    for (int axis = 0; cell_.periodic && axis < 3; ++axis) {
      x_i[axis] -= static_cast<double>(bucket.image[axis]) * cell_.size[axis];
    }
    const double reach_of_i = i.radius + reach_ + round_off(i);
    for (const Member& j : bucket.members) {
      if (same_class && j.row < i.row) continue;  // j finds it
      const double roughly = j.radius + reach_of_i;
      if ((j.folded - x_i).squaredNorm() > roughly * roughly) continue;
      const Pair pair = make_pair(i.row, j.row, bucket.image);
      if (pair.i == pair.j && !is_positive(pair.image)) continue;
      if (is_within_reach(particles_, cell_, pair, reach_)) found.push_back(pair);
    }
  }

  Pair make_pair(std::int32_t i, std::int32_t j, const ClassGrid::Index3& bucket_image) const {
    Pair pair{std::min(i, j), std::max(i, j), {0, 0, 0}};
    if (!cell_.periodic) return pair;
    for (int axis = 0; axis < 3; ++axis) {
      const std::int64_t image = bucket_image[axis] + places_[i].home[axis] - places_[j].home[axis];
      FRIT_EXPECT(std::abs(image) <= 127);
      pair.image[axis] = static_cast<std::int8_t>(i <= j ? image : -image);
    }
    return pair;
  }

  const Particles& particles_;
  const Cell& cell_;
  double reach_;
  std::vector<Place> places_;
  std::vector<RadiusClass> classes_;
};

// Counting sort by i, then each short row by itself: linear, and rows are independent.
std::vector<Pair> sort_pairs(const std::vector<Pair>& pairs, std::size_t particle_count) {
  std::vector<std::size_t> start(particle_count + 1, 0);
  for (const Pair& pair : pairs) ++start[pair.i + 1];
  for (std::size_t i = 0; i < particle_count; ++i) start[i + 1] += start[i];
  std::vector<Pair> sorted(pairs.size());
  std::vector<std::size_t> next(start.begin(), start.end() - 1);
  for (const Pair& pair : pairs) sorted[next[pair.i]++] = pair;
  parallel_for(particle_count, [&](std::size_t i) {
    std::sort(sorted.begin() + start[i], sorted.begin() + start[i + 1],
              [](const Pair& a, const Pair& b) { return std::tie(a.j, a.image) < std::tie(b.j, b.image); });
  });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

}  // namespace

std::vector<Pair> find_pairs(const Particles& particles, const Cell& cell, double reach) {
  FRIT_EXPECT(!cell.periodic || cell.size.minCoeff() > 0.0);
  FRIT_EXPECT(std::all_of(particles.position.begin(), particles.position.end(),
                          [](const Vec3& x) { return x.allFinite(); }));
  return sort_pairs(Search(particles, cell, reach).all_pairs(), particles.size());
}

}  // namespace frit::neighbor
