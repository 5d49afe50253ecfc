#include "observe/fields.hpp"

#include <utility>

#include "observe/non_affine.hpp"
#include "observe/rearrangement.hpp"
#include "observe/rotation.hpp"

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
          scalars("neck_angle_change [rad]", std::move(moved.neck_angle_change)),
          scalars("own_rotation [rad]", own_rotations(reference, state))};
}

ContactFields contact_fields(const State& state, const NeckLaw& law) {
  const Contacts& contacts = state.contacts;
  std::vector<double> age(contacts.size());
  for (std::size_t k = 0; k < age.size(); ++k) age[k] = state.time - contacts.birth_time[k];
  ContactFields fields{scalars("normal_force [N]", contacts.normal_force),
                       scalars("age [s]", std::move(age)),
                       scalars("approach_velocity [m/s]", contacts.approach_velocity),
                       vectors("sliding_velocity [m/s]", contacts.sliding_velocity),
                       scalars("rolling [rad]", contacts.rolling_path),
                       scalars("sliding", relative_sliding(state)),
                       scalars("twisting [rad]", contacts.twisting_path)};
  if (!law.neck_radius.empty()) {
    fields.push_back(scalars("neck_radius [m]", {law.neck_radius.begin(), law.neck_radius.end()}));
    fields.push_back(scalars("neck_ratio", neck_ratios(state, law)));
  }
  if (!law.normal_resistance.empty()) {
    fields.push_back(
        scalars("normal_resistance [N s/m]", {law.normal_resistance.begin(), law.normal_resistance.end()}));
    fields.push_back(scalars("sliding_resistance [N s/m]",
                             {law.sliding_resistance.begin(), law.sliding_resistance.end()}));
  }
  return fields;
}

}  // namespace frit::observe
