#include "run/neck_law.hpp"

#include <algorithm>
#include <cmath>

namespace frit::run {

NeckArrays necks_of(const contact::SinteringLaw& law, const State& state, double delta_b) {
  const Contacts& contacts = state.contacts;
  const bool diffuses = delta_b > 0.0;
  NeckArrays necks;
  necks.neck_radius.resize(contacts.size());
  necks.normal_resistance.resize(diffuses ? contacts.size() : 0);
  necks.sliding_resistance.resize(diffuses ? contacts.size() : 0);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const contact::Pairing pair(state.particles.radius[static_cast<std::size_t>(contacts.i[k])],
                                state.particles.radius[static_cast<std::size_t>(contacts.j[k])]);
    const double largest = contact::equilibrium_neck_radius(law, pair);
    const double q = std::clamp(contacts.neck_radius_squared[k], 0.0, largest * largest);
    necks.neck_radius[k] = std::sqrt(q);
    if (!diffuses) continue;
    const contact::Resistances c = contact::resistances(law, pair, q, delta_b);
    necks.normal_resistance[k] = c.normal;
    necks.sliding_resistance[k] = c.sliding;
  }
  return necks;
}

}  // namespace frit::run
