#include "generate/soft_spheres.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "core/abandoned.hpp"
#include "core/constants.hpp"
#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "state/state.hpp"

namespace frit::generate {
namespace {

constexpr double longest_move = 0.1;  // of a sphere in a step: random points start with huge overlaps
constexpr double longest_travel =
    (SoftSpheres::skin - longest_move) / 2.0;  // before the pairs are listed anew

bool comes_before(const neighbor::Pair& a, const neighbor::Pair& b) {
  return std::tie(a.i, a.j, a.image) < std::tie(b.i, b.j, b.image);
}

// FIRE's two knobs and how they follow the power; the paper's values but for the limits of dt, which suit the
// stiffest mode of about 12 contacts, and the floor of the mixing, without which soft modes ring for long.
struct Pace {
  double dt = 0.1, mixing = 0.1;
  int downhill_steps = 0;

  void follow(double power) {
    if (power <= 0.0) {
      *this = {std::max(0.5 * dt, 0.02), 0.1, 0};
    } else if (++downhill_steps > 5) {
      dt = std::min(1.1 * dt, 0.3);
      mixing = std::max(0.99 * mixing, 0.03);
    }
  }
};

}  // namespace

struct SoftSpheres::Sums {
  double power = 0.0, speed_squared = 0.0, force_squared = 0.0;
  double overlap = 0.0;  // each contact counted from both sides, as below
  double contacts = 0.0;
  double travel_squared = 0.0;  // the largest

  Sums& operator+=(const Sums& other) {
    power += other.power;
    speed_squared += other.speed_squared;
    force_squared += other.force_squared;
    overlap += other.overlap;
    contacts += other.contacts;
    travel_squared = std::max(travel_squared, other.travel_squared);
    return *this;
  }
};

SoftSpheres::SoftSpheres(std::vector<Vec3> positions, std::vector<double> radii, double relative_density) {
  FRIT_EXPECT(positions.size() == radii.size() && relative_density > 0.0);
  double solid = 0.0;
  for (const double r : radii) solid += 4.0 / 3.0 * pi * r * r * r;
  cell_ = {true, Vec3::Constant(std::cbrt(solid / relative_density))};
  for (Vec3& x : positions) x = x.cwiseProduct(cell_.size);
  spheres_.position = std::move(positions);
  spheres_.radius = std::move(radii);
}

void SoftSpheres::bond(std::vector<neighbor::Pair> pairs, double rest_ratio) {
  FRIT_EXPECT(std::is_sorted(pairs.begin(), pairs.end(), comes_before));
  bonds_ = std::move(pairs);
  rest_ratio_ = rest_ratio;
}

std::vector<neighbor::Pair> SoftSpheres::pairs_within(double gap) const {
  return neighbor::find_pairs(spheres_, cell_, gap);
}

double SoftSpheres::distance_ratio(const neighbor::Pair& pair) const {
  const Vec3 apart = cell_.separation(spheres_.position[pair.i], spheres_.position[pair.j], pair.image);
  return apart.norm() / (spheres_.radius[pair.i] + spheres_.radius[pair.j]);
}

void SoftSpheres::list_sides() {
  const auto pairs = pairs_within(skin);
  const std::size_t count = spheres_.size();
  first_side_.assign(count + 1, 0);
  for (const auto& pair : pairs) {
    ++first_side_[pair.i + 1];
    ++first_side_[pair.j + 1];
  }
  for (std::size_t i = 0; i < count; ++i) first_side_[i + 1] += first_side_[i];
  std::vector<std::size_t> next(first_side_.begin(), first_side_.end() - 1);
  sides_.resize(first_side_[count]);
  for (const auto& pair : pairs) {
    const double r_i = spheres_.radius[pair.i], r_j = spheres_.radius[pair.j];
    const bool bonded = std::binary_search(bonds_.begin(), bonds_.end(), pair, comes_before);
    const double rest_overlap = bonded ? rest_ratio_ * equivalent_radius(r_i, r_j) : 0.0;
    const Vec3 shift = cell_.shift(pair.image);
    sides_[next[pair.i]++] = {shift, r_i + r_j, rest_overlap, pair.j, bonded};
    sides_[next[pair.j]++] = {-shift, r_i + r_j, rest_overlap, pair.i, bonded};
  }
  listed_positions_ = spheres_.position;
}

Vec3 SoftSpheres::force_on(std::size_t i, Sums& sums) const {
  Vec3 force = Vec3::Zero();
  for (std::size_t s = first_side_[i]; s < first_side_[i + 1]; ++s) {
    const Side& side = sides_[s];
    const Vec3 apart = spheres_.position[side.other] + side.shift - spheres_.position[i];
    const double distance_squared = apart.squaredNorm();
    const bool overlaps = distance_squared < side.contact_distance * side.contact_distance;
    if (!overlaps && !side.bonded) continue;
    const double distance = std::sqrt(distance_squared);
    const double overlap = side.contact_distance - distance;
    if (overlaps) {
      sums.overlap += overlap;
      sums.contacts += 1.0;
    }
    if (distance > 0.0) force -= (overlap - side.rest_overlap) / distance * apart;
  }
  return force;
}

SoftSpheres::Sums SoftSpheres::compute_forces() {
  return ordered_sum(spheres_.size(), Sums{}, [this](std::size_t begin, std::size_t end) {
    Sums sums;
    for (std::size_t i = begin; i < end; ++i) {
      forces_[i] = force_on(i, sums);
      sums.power += forces_[i].dot(velocities_[i]);
      sums.speed_squared += velocities_[i].squaredNorm();
      sums.force_squared += forces_[i].squaredNorm();
      const double travel_squared = (spheres_.position[i] - listed_positions_[i]).squaredNorm();
      sums.travel_squared = std::max(sums.travel_squared, travel_squared);
    }
    return sums;
  });
}

RelaxReport SoftSpheres::report_of(const Sums& sums, int step) const {
  const auto count = static_cast<double>(spheres_.size());
  RelaxReport report{.steps = step, .coordination = sums.contacts / count};
  if (sums.contacts > 0.0) report.mean_overlap = sums.overlap / sums.contacts;
  const double force_scale = bonds_.empty() ? report.mean_overlap : rest_ratio_;
  if (force_scale > 0.0) report.force_ratio = std::sqrt(sums.force_squared / count) / force_scale;
  return report;
}

RelaxReport SoftSpheres::relax(const RelaxOptions& options) {
  velocities_.assign(spheres_.size(), Vec3::Zero());
  forces_.assign(spheres_.size(), Vec3::Zero());
  list_sides();
  Pace pace;
  for (int step = 0;; ++step) {
    if (abandon_ && abandon_()) throw Abandoned("the packing is not made");
    const Sums sums = compute_forces();
    const RelaxReport report = report_of(sums, step);
    const bool apart = bonds_.empty() && report.mean_overlap <= options.overlap_tolerance;
    const bool done = apart || report.force_ratio <= options.force_tolerance || step == options.most_steps;
    if (done) return report;
    pace.follow(sums.power);
    const bool downhill = sums.power > 0.0;
    const double kept = downhill ? 1.0 - pace.mixing : 0.0;
    const double turned = downhill ? pace.mixing * std::sqrt(sums.speed_squared / sums.force_squared) : 0.0;
    parallel_for(spheres_.size(), [&](std::size_t i) {
      velocities_[i] = kept * velocities_[i] + (turned + pace.dt) * forces_[i];
      Vec3 move = pace.dt * velocities_[i];
      if (move.norm() > longest_move) move *= longest_move / move.norm();
      spheres_.position[i] += move;
    });
    if (sums.travel_squared > longest_travel * longest_travel) list_sides();
  }
}

}  // namespace frit::generate
