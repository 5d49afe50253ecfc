// A hashed grid over the spheres of one class of radii. Cells are hashed into a table of about twice as many
// buckets as spheres, so that neither a far outlier nor a hollow or slanted body costs memory or time.
// Spheres of other grid cells may share a bucket: whoever asks checks the distance anyway.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "state/cell.hpp"
#include "state/particles.hpp"

namespace frit::neighbor {

// A sphere's place: its position folded into the cell, and how many edges it was moved by.
struct Place {
  Vec3 folded;                       // [m], in [0, size) when periodic, else the position itself
  std::array<std::int64_t, 3> home;  // position = folded + home * size
};

// Places of all particles; positions must be finite.
std::vector<Place> find_places(const Particles& particles, const Cell& cell);

// What the search reads of a sphere, kept together in memory bucket by bucket.
struct Member {
  Vec3 folded;    // [m]
  double radius;  // [m]
  std::int32_t row;
};

class ClassGrid {
 public:
  using Index3 = std::array<std::int64_t, 3>;

  // edge [m] > 0: wished width of the grid cells.
  ClassGrid(const std::vector<Member>& members, const Cell& cell, double edge);

  // Grid cell, unwrapped when periodic, that holds the point [m].
  Index3 index_of(const Vec3& point) const;

  // Spheres hashed to the bucket of an (unwrapped) grid cell, and the periodic image of that grid cell.
  struct Bucket {
    std::span<const Member> members;
    Index3 image;
  };
  Bucket bucket(const Index3& index) const;

  // All members, bucket by bucket: near spheres follow each other.
  std::span<const Member> members() const { return members_; }

 private:
  std::size_t slot_of(const Index3& wrapped) const;

  bool periodic_;
  Vec3 width_;                       // [m], of a grid cell
  Index3 cells_ = {1, 1, 1};         // grid cells along each edge of a periodic cell
  std::size_t mask_ = 0;             // number of buckets - 1, a power of two minus one
  std::vector<std::int32_t> start_;  // first member of each bucket, and the end of the last
  std::vector<Member> members_;
};

}  // namespace frit::neighbor
