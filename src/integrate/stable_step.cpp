#include "integrate/stable_step.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

#include "core/constants.hpp"
#include "core/parallel.hpp"

namespace frit::integrate {
namespace {

using Matrix6 = Eigen::Matrix<double, 6, 6>;

// What one contact resists, seen from one of its particles [N s/m] and [N m s].
struct Resisted {
  Vec3 normal;
  contact::Resistances c;
};

// (v, w) of one particle alone, with its inertia taken out.
void add_contact(const Resisted& contact, double arm, const VerletInertia& own, Matrix6& sum) {
  const Mat3 along = contact.normal * contact.normal.transpose(), across = Mat3::Identity() - along;
  const double coupling = std::sqrt(own.inverse_mass * own.inverse_moment);
  const contact::Resistances& c = contact.c;
  sum.topLeftCorner<3, 3>() += own.inverse_mass * (c.normal * along + c.sliding * across);
  sum.topRightCorner<3, 3>() -= coupling * arm * c.sliding * cross_matrix(contact.normal);
  sum.bottomRightCorner<3, 3>() +=
      own.inverse_moment * ((c.sliding * arm * arm + c.rolling) * across + c.twisting * along);
}

double largest_eigenvalue(Matrix6& matrix) {
  matrix.bottomLeftCorner<3, 3>() = matrix.topRightCorner<3, 3>().transpose();
  const Eigen::SelfAdjointEigenSolver<Matrix6> solver(matrix, Eigen::EigenvaluesOnly);
  return solver.eigenvalues()[5];
}

class Bound {
 public:
  Bound(VerletList& list, const StableStepInput& input) : list_(list), in_(input) {}

  double value() {
    std::vector<double> worst(list_.blocks(), 0.0), cell(list_.blocks(), 0.0);
    parallel_blocks(in_.bodies.size(), [&](std::size_t begin, std::size_t end) {
      const std::size_t block = begin / block_size;
      std::vector<Matrix6> sums(block_size + 1, Matrix6::Zero());
      for (const VerletPair& pair : list_.pairs(block)) cell[block] += add(pair, sums);
      for (std::size_t n = begin; n < end; ++n) {
        worst[block] = std::max(worst[block], largest_eigenvalue(sums[n - begin]));
      }
    });
    double bound = 0.0, of_cell = 0.0;
    for (const double rate : worst) bound = std::max(bound, rate);
    for (const double rate : cell) of_cell += rate;
    // (a - b)^2 <= 2 a^2 + 2 b^2 for the two ends of a contact; rates of cell and particles add up.
    return 2.0 * bound + of_cell;
  }

 private:
  contact::Resistances resistances_of(const VerletPair& pair, double distance) const {
    const double radius_i = pair.arm_share * pair.sum_radii, equivalent = 0.5 * pair.growth;
    const contact::Pairing pairing(radius_i, pair.sum_radii - radius_i);
    const double heavier = std::min(in_.inertia[pair.i].inverse_mass, in_.inertia[pair.j].inverse_mass);
    const double x_c =
        heavier > 0.0 ? inertial_neck_ratio(in_.delta_b, pair.least_pull, 1.0 / heavier, equivalent) : 0.0;
    const double youngest = std::max(x_c, in_.law.birth_neck_ratio) * equivalent;
    double q = youngest * youngest;
    if (pair.kind == PairKind::neck) {
      q = std::max(q, pair.growth * (pair.sum_radii - distance) + pair.offset);
    }
    return contact::resistances(in_.law, pairing, std::min(q, pair.cap), in_.delta_b);
  }

  // Returns what the contact adds to the rate of the cell's strain.
  double add(const VerletPair& pair, std::vector<Matrix6>& sums) const {
    const Vec3 d = to_vec3(in_.bodies[pair.j].x + in_.shifts[pair.image] - in_.bodies[pair.i].x);
    const double distance = d.norm(), arm = pair.arm_share * distance;
    const Resisted contact{d / distance, resistances_of(pair, distance)};
    add_contact(contact, arm, in_.inertia[pair.i], sums[pair.slot_i]);
    add_contact({-contact.normal, contact.c}, distance - arm, in_.inertia[pair.j], sums[pair.slot_j]);
    if (!pair.is_owner) return 0.0;
    double rate = 0.0;
    for (int axis = 0; axis < 3; ++axis) {
      const double share = contact.normal[axis] * contact.normal[axis];
      rate += in_.axis_inverse_mass[axis] * d[axis] * d[axis] *
              (contact.c.normal * share + contact.c.sliding * (1.0 - share));
    }
    return rate;
  }

  VerletList& list_;
  const StableStepInput& in_;
};

}  // namespace

double inertial_neck_ratio(double delta_b, double attraction, double mass, double equivalent) {
  return std::pow(384.0 * delta_b * delta_b * attraction * mass / (pi * pi * std::pow(equivalent, 9)), 0.1);
}

double largest_rate(VerletList& list, const StableStepInput& input) { return Bound(list, input).value(); }

}  // namespace frit::integrate
