#include "contact/neck_history.hpp"

#include <cmath>

#include "core/parallel.hpp"

namespace frit::contact {

void add_step_to_paths(State& state) {
  Contacts& contacts = state.contacts;
  const Particles& particles = state.particles;
  const double dt = state.last_step;
  parallel_for(contacts.size(), [&](std::size_t k) {
    const auto i = static_cast<std::size_t>(contacts.i[k]), j = static_cast<std::size_t>(contacts.j[k]);
    const Vec3 arm =
        state.cell.separation(particles.position[i], particles.position[j], contacts.image[k]).normalized();
    const Vec3 spin = particles.spin[j] - particles.spin[i];
    const double twist = spin.dot(arm);
    contacts.rolling_path[k] += (spin - twist * arm).norm() * dt;
    contacts.twisting_path[k] += std::abs(twist) * dt;
    contacts.sliding_path[k] += contacts.sliding_velocity[k].norm() * dt;
  });
}

}  // namespace frit::contact
