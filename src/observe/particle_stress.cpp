#include "observe/particle_stress.hpp"

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace frit::observe {
namespace {

double volume(double radius) { return 4.0 / 3.0 * pi * radius * radius * radius; }

// Force on particle i [N] when the normal points from i to j.
Vec3 force_on_first(const Contacts& contacts, const NeckLaw& law, std::size_t k, const Vec3& normal) {
  Vec3 force = -contacts.normal_force[k] * normal;
  if (!law.sliding_resistance.empty()) force -= law.sliding_resistance[k] * contacts.sliding_velocity[k];
  return force;
}

}  // namespace

std::vector<Mat3> particle_stresses(const State& state, const NeckLaw& law) {
  const Contacts& contacts = state.contacts;
  const auto& radius = state.particles.radius;
  FRIT_EXPECT(law.sliding_resistance.empty() || law.sliding_resistance.size() == contacts.size());
  std::vector<Mat3> stresses(state.particles.size(), Mat3::Zero());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto i = static_cast<std::size_t>(contacts.i[k]), j = static_cast<std::size_t>(contacts.j[k]);
    const Vec3 branch =
        state.cell.separation(state.particles.position[i], state.particles.position[j], contacts.image[k]);
    const Vec3 force = force_on_first(contacts, law, k, branch.normalized());
    // Both arms and forces change sign from i to j, their product does not.
    const Mat3 moment = branch * force.transpose() / (radius[i] + radius[j]);
    const Mat3 symmetric = 0.5 * (moment + moment.transpose());
    stresses[i] += radius[i] / volume(radius[i]) * symmetric;
    stresses[j] += radius[j] / volume(radius[j]) * symmetric;
  }
  return stresses;
}

Mat3 mean_stress(const State& state, const std::vector<Mat3>& stresses, double relative_density) {
  Mat3 sum = Mat3::Zero();
  double whole = 0.0;
  for (std::size_t row = 0; row < stresses.size(); ++row) {
    sum += volume(state.particles.radius[row]) * stresses[row];
    whole += volume(state.particles.radius[row]);
  }
  return relative_density / whole * sum;
}

}  // namespace frit::observe
