#include "observe/fields.hpp"

#include <cmath>
#include <utility>

#include "observe/non_affine.hpp"
#include "observe/rearrangement.hpp"

namespace frit::observe {
namespace {

Field scalars(std::string name, std::vector<double> values) {
  return {std::move(name), 1, std::move(values)};
}

Field vectors(std::string name, const std::vector<Vec3>& vectors) {
  Field field{std::move(name), 3, {}};
  field.values.reserve(3 * vectors.size());
  for (const Vec3& vector : vectors) field.values.insert(field.values.end(), vector.begin(), vector.end());
  return field;
}

// The turn that leads to an orientation, as axis times angle (at most half a turn).
Vec3 rotation_vector(const Quat& orientation) {
  const double sine = orientation.vec().norm();  // of half the angle
  if (sine == 0.0) return Vec3::Zero();
  const double angle = 2.0 * std::atan2(sine, std::abs(orientation.w()));
  return std::copysign(angle / sine, orientation.w()) * orientation.vec();
}

}  // namespace

ParticleFields particle_fields(const Reference& reference, const State& state) {
  Rearrangement moved = rearrangement_since(reference, state);
  std::vector<Vec3> rotations;
  rotations.reserve(state.particles.size());
  for (const Quat& orientation : state.particles.orientation)
    rotations.push_back(rotation_vector(orientation));
  return {scalars("coordination", coordination_numbers(state)),
          vectors("rotation [rad]", rotations),
          vectors("non_affine_velocity [m/s]", non_affine_velocities(state)),
          scalars("rearrangement_deviation", std::move(moved.deviation)),
          scalars("rearrangement_d2min", std::move(moved.d2min)),
          scalars("contacts_gained", std::move(moved.contacts_gained)),
          scalars("contacts_lost", std::move(moved.contacts_lost)),
          scalars("neck_angle_change [rad]", std::move(moved.neck_angle_change))};
}

ContactFields contact_fields(const State& state, const NeckLaw& law) {
  const Contacts& contacts = state.contacts;
  std::vector<double> age(contacts.size());
  for (std::size_t k = 0; k < age.size(); ++k) age[k] = state.time - contacts.birth_time[k];
  ContactFields fields{scalars("normal_force [N]", contacts.normal_force), scalars("age [s]", std::move(age)),
                       scalars("approach_velocity [m/s]", contacts.approach_velocity),
                       vectors("sliding_velocity [m/s]", contacts.sliding_velocity)};
  if (!law.neck_radius.empty()) {
    fields.push_back(scalars("neck_radius [m]", {law.neck_radius.begin(), law.neck_radius.end()}));
    fields.push_back(scalars("neck_ratio", neck_ratios(state, law)));
  }
  return fields;
}

}  // namespace frit::observe
