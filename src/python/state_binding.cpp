#include "python/state_binding.hpp"

#include <memory>
#include <utility>
#include <vector>

#include "observe/fields.hpp"
#include "python/arrays.hpp"
#include "python/session.hpp"

namespace frit::python {
namespace {

using Class = py::class_<Moment, std::shared_ptr<Moment>>;

// A property that is a view of a vector of the moment; the view keeps the moment alive.
template <class Get>
void add_view(Class& type, const char* name, Get get, const char* text) {
  type.def_property_readonly(
      name, [get](const py::object& self) { return view_of(get(self.cast<const Moment&>()), self); }, text);
}

template <class Get>
void add_particle_view(Class& type, const char* name, Get member, const char* text) {
  add_view(
      type, name, [member](const Moment& at) -> const auto& { return at.state.particles.*member; }, text);
}

template <class Get>
void add_contact_view(Class& type, const char* name, Get member, const char* text) {
  add_view(
      type, name, [member](const Moment& at) -> const auto& { return at.state.contacts.*member; }, text);
}

void add_particles(Class& type) {
  add_particle_view(type, "ids", &Particles::id, "(N,) int64: stable ids, ascending.");
  add_particle_view(type, "positions", &Particles::position, "(N, 3) [m]: centres.");
  add_particle_view(type, "radii", &Particles::radius, "(N,) [m].");
  add_particle_view(type, "masses", &Particles::mass, "(N,) [kg]: real density times volume.");
  add_particle_view(type, "velocities", &Particles::velocity, "(N, 3) [m/s]: mean over the last step.");
  add_particle_view(type, "spins", &Particles::spin, "(N, 3) [1/s]: mean over the last step.");
  add_particle_view(type, "orientations", &Particles::orientation,
                    "(N, 4): turn since the start as quaternions x, y, z, w.");
  add_particle_view(type, "forces", &Particles::force, "(N, 3) [N]: external forces.");
}

void add_contacts(Class& type) {
  add_contact_view(type, "contact_i", &Contacts::i, "(K,) int32: row of the first particle, i <= j.");
  add_contact_view(type, "contact_j", &Contacts::j, "(K,) int32: row of the second particle.");
  add_contact_view(type, "contact_images", &Contacts::image,
                   "(K, 3) int8: the periodic copy of j that touches i, in cell edges.");
  add_contact_view(type, "overlaps", &Contacts::overlap, "(K,) [m]: R_i + R_j - distance.");
  add_contact_view(type, "normal_forces", &Contacts::normal_force,
                   "(K,) [N]: mean over the last step, positive repels.");
  add_contact_view(type, "approach_velocities", &Contacts::approach_velocity,
                   "(K,) [m/s]: mean over the last step, positive approaches.");
  add_contact_view(type, "sliding_velocities", &Contacts::sliding_velocity,
                   "(K, 3) [m/s]: at the contact point, mean over the last step.");
  add_contact_view(type, "birth_times", &Contacts::birth_time, "(K,) [s]; 0: contact of the packing.");
  add_view(
      type, "neck_radii", [](const Moment& at) -> const auto& { return at.necks.neck_radius; },
      "(K,) [m]: radius r of each neck.");
  add_view(
      type, "neck_ratios", [](const Moment& at) -> const auto& { return at.neck_ratios; },
      "(K,): r/R, R the equivalent radius.");
}

py::dict dict_of(std::vector<observe::Field> fields) {
  py::dict dict;
  for (observe::Field& field : fields)
    dict[py::str(field.name)] = array_of(std::move(field.values), field.components);
  return dict;
}

py::object cell_size(const Moment& at) {
  if (!at.state.cell.periodic) return py::none();
  const Vec3& size = at.state.cell.size;
  return array_of(std::vector<double>{size.x(), size.y(), size.z()});
}

}  // namespace

void add_state(py::module_& module) {
  Class type(module, "State",
             "Particles and contacts at one moment, as a run's Simulation.state gives them. Rows follow the "
             "stable ids. Arrays are read-only views without copies; they keep the State alive, and later "
             "steps do not change them. SI units.");
  type.def_property_readonly(
      "time", [](const Moment& at) { return at.state.time; }, "[s]");
  type.def_property_readonly(
      "temperature", [](const Moment& at) { return at.state.temperature; }, "[K]");
  type.def_property_readonly(
      "theta", [](const Moment& at) { return at.state.theta; },
      "[m^5 s/(N s)]: integral of Delta_b over time.");
  type.def_property_readonly(
      "relative_density", [](const Moment& at) { return at.density; }, "NaN where the run knows none.");
  type.def_property_readonly("cell_size", &cell_size, "(3,) [m]: edges of the periodic cell; else None.");
  add_particles(type);
  add_contacts(type);
  type.def(
      "particle_fields",
      [](const Moment& at) { return dict_of(observe::particle_fields(at.setup->reference, at.state)); },
      "Dict of (N,) or (N, 3) arrays, made anew: what snapshots hold of the particles.");
  type.def(
      "contact_fields",
      [](const Moment& at) { return dict_of(observe::contact_fields(at.state, at.necks.view())); },
      "Dict of (K,) or (K, 3) arrays, made anew: what snapshots hold of the contacts.");
}

}  // namespace frit::python
