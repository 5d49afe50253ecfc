// The affine part of a motion: what the body did as a whole.
#pragma once

#include <span>

#include "core/vec.hpp"
#include "observe/reference.hpp"
#include "state/state.hpp"

namespace frit::observe {

// The affine map to = to_centre + gradient (from - from_centre) nearest to the points, by least squares.
struct AffineFit {
  Mat3 gradient;
  Vec3 from_centre, to_centre;  // means of the points
};
// Both spans have one length. Points `from` that do not span space leave the gradient without a value (NaN).
AffineFit fit_affine(std::span<const Vec3> from, std::span<const Vec3> to);

// Motion since the reference: gradient F = Q U with rotation Q and symmetric stretch U.
// Free body: best fit over all centres; periodic cell: its change of edge lengths, Q = 1.
struct Motion {
  Mat3 rotation;                  // Q; NaN like the rest when the centres do not span space
  double isotropic_stretch;       // lambda = cbrt(det F)
  Vec3 linear_strain;             // free: diagonal of ln U; periodic: of the cell
  Vec3 reference_centre, centre;  // [m], means of the centres then and now
};
Motion motion_since(const Reference& reference, const State& state);

}  // namespace frit::observe
