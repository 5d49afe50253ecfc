#include "observe/rearrangement.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/parallel.hpp"
#include "observe/motion.hpp"
#include "observe/statistics.hpp"

namespace frit::observe {
namespace {

constexpr std::size_t fewest_neighbours = 4;  // of a local affine map
constexpr double least_stretch = 1e-12;       // a body nearer to its first size has not shrunk

// A pair of neighbours seen from one of them: the vector to the other, then and now [m].
struct Arm {
  Vec3 then, now;
};

// The reference and the positions of now, both in the reference's order.
struct Comparison {
  const Reference& reference;
  const Cell& cell;
  std::vector<Vec3> position;  // [m]

  void find_arms(std::size_t row, std::vector<Arm>& arms) const {
    arms.clear();
    for (const Neighbour& other : reference.neighbours.of(row)) {
      const Vec3 then =
          reference.cell.separation(reference.position[row], reference.position[other.row], other.image);
      arms.push_back({then, cell.separation(position[row], position[other.row], other.image)});
    }
  }
};

// Symmetric; directions without neighbours are left out.
Mat3 inverse_of_moments(const Mat3& moments) {
  constexpr double nearly_flat = 1e-9;
  const double size = moments.trace();
  if (moments.determinant() > nearly_flat * size * size * size) return moments.inverse();
  const Eigen::SelfAdjointEigenSolver<Mat3> solver(moments);
  const double floor = nearly_flat * size;
  const Vec3 inverse =
      solver.eigenvalues().unaryExpr([=](double value) { return value > floor ? 1.0 / value : 0.0; });
  return solver.eigenvectors() * inverse.asDiagonal() * solver.eigenvectors().transpose();
}

// Falk & Langer's D^2_min, as a mean over the neighbours [m^2].
double local_rest(const std::vector<Arm>& arms) {
  if (arms.size() < fewest_neighbours) return no_value;
  Mat3 mixed = Mat3::Zero(), own = Mat3::Zero();
  for (const Arm& arm : arms) {
    mixed += arm.now * arm.then.transpose();
    own += arm.then * arm.then.transpose();
  }
  const Mat3 map = mixed * inverse_of_moments(own);
  double sum = 0.0;
  for (const Arm& arm : arms) sum += (arm.now - map * arm.then).squaredNorm();
  return sum / static_cast<double>(arms.size());
}

// Sine and cosine of the change are formed from those of both angles: no digits are lost near 0 and 180
// degrees.
double angle_change(const Arm& one, const Arm& other) {
  const double sine_then = one.then.cross(other.then).norm(), cosine_then = one.then.dot(other.then);
  const double sine_now = one.now.cross(other.now).norm(), cosine_now = one.now.dot(other.now);
  return std::atan2(sine_now * cosine_then - cosine_now * sine_then,
                    cosine_now * cosine_then + sine_now * sine_then);
}

double pairs_among(std::size_t count) {
  return 0.5 * static_cast<double>(count) * (static_cast<double>(count) - 1.0);
}

double rms_angle_change(const std::vector<Arm>& arms) {
  if (arms.size() < 2) return no_value;
  double sum = 0.0;
  for (std::size_t first = 0; first < arms.size(); ++first) {
    for (std::size_t second = first + 1; second < arms.size(); ++second) {
      const double change = angle_change(arms[first], arms[second]);
      sum += change * change;
    }
  }
  return std::sqrt(sum / pairs_among(arms.size()));
}

double rms_over_all_pairs(const Reference& reference, const std::vector<double>& rms_per_row) {
  double sum = 0.0, pairs = 0.0;
  for (std::size_t row = 0; row < rms_per_row.size(); ++row) {
    const std::size_t count = reference.neighbours.of(row).size();
    if (count < 2) continue;
    sum += pairs_among(count) * rms_per_row[row] * rms_per_row[row];
    pairs += pairs_among(count);
  }
  return pairs > 0.0 ? std::sqrt(sum / pairs) : no_value;
}

struct PairSums {
  double deviation = 0.0, shrinkage = 0.0;  // [m]
  PairSums& operator+=(const PairSums& other) {
    deviation += other.deviation;
    shrinkage += other.shrinkage;
    return *this;
  }
};

double pair_ratio(const Comparison& compared, const Motion& motion) {
  if (!(std::abs(1.0 - motion.isotropic_stretch) > least_stretch)) return no_value;
  const Mat3 uniform = motion.isotropic_stretch * motion.rotation;
  const auto sums =
      ordered_sum(compared.position.size(), PairSums{}, [&](std::size_t begin, std::size_t end) {
        PairSums part;
        std::vector<Arm> arms;
        for (std::size_t row = begin; row < end; ++row) {
          compared.find_arms(row, arms);
          for (const Arm& arm : arms) {
            part.deviation += (arm.now - uniform * arm.then).norm();
            part.shrinkage += std::abs(1.0 - motion.isotropic_stretch) * arm.then.norm();
          }
        }
        return part;
      });
  return sums.shrinkage > 0.0 ? sums.deviation / sums.shrinkage : no_value;
}

// All by rows of the reference.
void measure_particles(const Comparison& compared, const Motion& motion, Rearrangement& result) {
  const Reference& reference = compared.reference;
  const Mat3 uniform = motion.isotropic_stretch * motion.rotation;
  const double radius = reference.mean_radius;
  parallel_blocks(reference.size(), [&](std::size_t begin, std::size_t end) {
    std::vector<Arm> arms;
    for (std::size_t row = begin; row < end; ++row) {
      compared.find_arms(row, arms);
      const Vec3 expected = uniform * (reference.position[row] - motion.reference_centre);
      result.deviation[row] = (compared.position[row] - motion.centre - expected).norm() / radius;
      result.d2min[row] = local_rest(arms) / (radius * radius);
      result.neck_angle_change[row] = rms_angle_change(arms);
    }
  });
}

// By rows of the state. A contact is the same when its particles and its image are.
void count_contact_changes(const Reference& reference, const State& state, const Correspondence& same,
                           Rearrangement& result) {
  for (std::size_t row = 0; row < same.reference_row.size(); ++row) {
    result.contacts_gained[row] = 0.0;
    result.contacts_lost[row] = static_cast<double>(reference.neighbours.of(same.reference_row[row]).size());
  }
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    const std::int32_t i = state.contacts.i[k], j = state.contacts.j[k];
    const auto old = reference.neighbours.of(same.reference_row[i]);
    const Neighbour other{same.reference_row[j], state.contacts.image[k]};
    const bool known = std::binary_search(old.begin(), old.end(), other);
    for (const std::int32_t end : {i, j}) {
      result.contacts_gained[end] += known ? 0.0 : 1.0;
      result.contacts_lost[end] -= known ? 1.0 : 0.0;
    }
  }
}

void put_in_order(const Correspondence& same, std::vector<double>& by_reference_row) {
  std::vector<double> by_row(by_reference_row.size());
  for (std::size_t row = 0; row < by_row.size(); ++row)
    by_row[row] = by_reference_row[same.reference_row[row]];
  by_reference_row.swap(by_row);
}

}  // namespace

Rearrangement rearrangement_since(const Reference& reference, const State& state) {
  const Correspondence same = match(reference, state.particles);
  const Comparison compared{reference, state.cell, positions_in_order(same, state.particles)};
  const Motion motion = motion_since(reference, state);
  Rearrangement result;
  for (auto* values : {&result.deviation, &result.d2min, &result.contacts_gained, &result.contacts_lost,
                       &result.neck_angle_change}) {
    values->resize(reference.size());
  }
  measure_particles(compared, motion, result);
  result.neck_angle_change_rms = rms_over_all_pairs(reference, result.neck_angle_change);
  for (auto* values : {&result.deviation, &result.d2min, &result.neck_angle_change})
    put_in_order(same, *values);
  count_contact_changes(reference, state, same, result);
  result.pair_ratio = pair_ratio(compared, motion);
  return result;
}

}  // namespace frit::observe
