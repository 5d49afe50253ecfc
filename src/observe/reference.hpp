// The state that a run's motion is measured from, kept in ascending order of the stable ids.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/vec.hpp"
#include "observe/neighbour_lists.hpp"
#include "state/state.hpp"

namespace frit::observe {

inline constexpr double core_share = 0.7;         // of the bounding box of the centres, in each direction
inline constexpr std::size_t smallest_core = 50;  // spheres; a smaller core has no density

// The inside of a free body, away from its surface.
struct Core {
  std::vector<std::int32_t> members;  // rows of the reference, ascending
  double relative_density;            // within the core's box; no_value when there are too few members
};

struct Reference {
  std::vector<std::int64_t> id;   // ascending; its index is the "row of the reference"
  std::vector<Vec3> position;     // [m], one per id
  std::vector<Quat> orientation;  // one per id
  NeighbourLists neighbours;      // pairs in contact, by rows of the reference
  Cell cell;
  Vec3 cell_strain = Vec3::Zero();  // logarithmic, of the state's account
  double mean_radius = 0.0;         // [m]
  Core core;                        // empty in a periodic cell

  std::size_t size() const { return id.size(); }
};

// The state as it is now, to be compared with later ones. Ids must be unique and not negative.
Reference take_reference(const State& state);

// Which particle is which, between the reference and a later state of the same particles.
struct Correspondence {
  std::vector<std::int32_t> row;            // of the state, one per row of the reference
  std::vector<std::int32_t> reference_row;  // one per row of the state
};
Correspondence match(const Reference& reference, const Particles& particles);

// Positions [m] of the state in the reference's order.
std::vector<Vec3> positions_in_order(const Correspondence& same, const Particles& particles);

}  // namespace frit::observe
