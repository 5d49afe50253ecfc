// Soft spheres in a periodic cell that push each other apart, or hold together where bonded, until their
// forces balance: the engine of random packings. Stiffness, mass and mean radius are 1; lengths and forces
// follow.
#pragma once

#include <cstdint>
#include <functional>
#include <utility>
#include <vector>

#include "neighbor/neighbor.hpp"

namespace frit::generate {

struct RelaxOptions {
  double force_tolerance = 0.05;     // balanced: RelaxReport::force_ratio not above it
  double overlap_tolerance = 0.001;  // apart: mean_overlap not above it; not asked of bonded spheres
  int most_steps = 1000;
};

struct RelaxReport {
  int steps = 0;
  double mean_overlap = 0.0;  // over pairs that overlap; 0 without any
  double force_ratio = 0.0;   // rms net force / mean overlap; with bonds, rms net force / rest ratio
  double coordination = 0.0;  // 2 overlapping pairs / spheres
};

class SoftSpheres {
 public:
  // Positions anywhere; radii with mean 1. The cube's edge is such that sphere volume / cell volume is
  // `relative_density`; positions are given in edges of it.
  SoftSpheres(std::vector<Vec3> positions, std::vector<double> radii, double relative_density);

  // relax asks this before each of its steps, and throws Abandoned where it says so.
  void abandon_when(std::function<bool()> asked) { abandon_ = std::move(asked); }

  // Lowers the elastic energy by the damped dynamics FIRE (Bitzek et al., Phys. Rev. Lett. 97, 170201, 2006)
  // until the forces balance, the spheres are apart or the steps are used up.
  RelaxReport relax(const RelaxOptions& options);

  // These pairs, sorted as by find_pairs, replace the bonded ones. The force of a bonded pair is zero at the
  // overlap rest_ratio * (equivalent radius), and beyond it pulls; a gap of more than `skin` breaks the bond.
  void bond(std::vector<neighbor::Pair> pairs, double rest_ratio);

  // Pairs with gaps up to `gap` <= skin, now.
  std::vector<neighbor::Pair> pairs_within(double gap) const;

  // Distance / sum of radii of a pair, now.
  double distance_ratio(const neighbor::Pair& pair) const;

  const std::vector<Vec3>& positions() const { return spheres_.position; }
  const std::vector<double>& radii() const { return spheres_.radius; }
  const Cell& cell() const { return cell_; }

  static constexpr double skin = 0.15;  // gap up to which pairs are listed

 private:
  // One side of a pair, in the list of one of its spheres.
  struct Side {
    Vec3 shift;               // of the other sphere's image
    double contact_distance;  // sum of radii
    double rest_overlap;      // 0 unless bonded
    std::int32_t other;
    bool bonded;
  };
  struct Sums;

  void list_sides();
  Vec3 force_on(std::size_t i, Sums& sums) const;
  Sums compute_forces();
  RelaxReport report_of(const Sums& sums, int step) const;

  Particles spheres_;  // only positions and radii are filled
  Cell cell_;
  std::vector<Vec3> velocities_, forces_, listed_positions_;
  std::vector<std::size_t> first_side_;  // one per sphere, and the end
  std::vector<Side> sides_;
  std::vector<neighbor::Pair> bonds_;
  double rest_ratio_ = 0.0;
  std::function<bool()> abandon_;
};

}  // namespace frit::generate
