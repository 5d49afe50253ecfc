#include "generate/lattice.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace frit::generate {
namespace {

struct UnitCell {
  double edge;              // in radii, such that nearest neighbours touch
  std::vector<Vec3> basis;  // in edges
};

UnitCell unit_cell(LatticeKind kind) {
  switch (kind) {
    case LatticeKind::simple_cubic:
      return {2.0, {{0, 0, 0}}};
    case LatticeKind::body_centred_cubic:
      return {4.0 / std::sqrt(3.0), {{0, 0, 0}, {0.5, 0.5, 0.5}}};
    case LatticeKind::face_centred_cubic:
      return {2.0 * std::sqrt(2.0), {{0, 0, 0}, {0, 0.5, 0.5}, {0.5, 0, 0.5}, {0.5, 0.5, 0}}};
  }
  throw ContractError("unknown lattice kind");
}

void check(double radius, std::int64_t largest_count) {
  std::vector<std::string> faults;
  if (!(radius > 0.0 && std::isfinite(radius)))
    faults.push_back(fmt::format("radius: {} m; allowed is a positive length", radius));
  if (largest_count < 1) faults.push_back(fmt::format("count: {}; allowed is 1 or more", largest_count));
  if (!faults.empty()) throw InputError(faults);
}

// Cells along each edge; the cube root may round to either side of a whole number.
int cells_along_edge(std::int64_t largest_count, std::size_t per_cell) {
  const std::int64_t cells = largest_count / static_cast<std::int64_t>(per_cell);
  auto along = static_cast<std::int64_t>(std::cbrt(static_cast<double>(cells))) + 1;
  while (along > 1 && along * along * along > cells) --along;
  return static_cast<int>(along);
}

}  // namespace

Packing make_lattice(LatticeKind kind, double radius, std::int64_t largest_count, Boundary boundary) {
  check(radius, largest_count);
  const UnitCell unit = unit_cell(kind);
  const int along = cells_along_edge(largest_count, unit.basis.size());
  const double edge = unit.edge * radius;
  Packing packing;
  if (boundary == Boundary::periodic) packing.cell = {true, Vec3::Constant(along * edge)};
  for (int z = 0; z < along; ++z) {
    for (int y = 0; y < along; ++y) {
      for (int x = 0; x < along; ++x) {
        for (const Vec3& b : unit.basis) packing.particles.add(edge * (Vec3(x, y, z) + b), radius);
      }
    }
  }
  return packing;
}

}  // namespace frit::generate
