#include "run/setup_checks.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/constants.hpp"
#include "integrate/stable_step.hpp"
#include "neighbor/neighbor.hpp"

namespace frit::run {
namespace {

constexpr std::size_t most_shown = 20;
// Given necks may bridge at most this share of the smaller radius; wider gaps are wrong indices or units.
constexpr double widest_neck_gap = 0.1;
// Round-off of coordinates over the smallest radius. The overlap of a new neck is about 5e-4 of it.
constexpr double coarsest_round_off = 1e-7;
// Steps of fixed length that a run may need: more would take years, and be lost in the round-off of the time.
constexpr double most_fixed_steps = 1e12;

// Adds the first faults of a kind and counts the others.
class Counted {
 public:
  explicit Counted(FaultTexts& faults) : faults_(faults) {}
  ~Counted() {
    if (count_ > most_shown) faults_.push_back(fmt::format("and {} more of this kind", count_ - most_shown));
  }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  void add(const std::string& fault) {
    if (++count_ <= most_shown) faults_.push_back(fault);
  }

 private:
  FaultTexts& faults_;
  std::size_t count_ = 0;
};

std::string origin_of(const config::Case& whole) {
  return whole.packing.file ? whole.packing.file->string() : "packing.generate";
}

// Solid volume in a periodic cell over that of the cell.
double filled_share(const generate::Packing& packing) {
  double solid = 0.0;
  for (const double radius : packing.particles.radius) solid += 4.0 / 3.0 * pi * radius * radius * radius;
  return solid / packing.cell.volume();
}

void check_cell(const generate::Packing& packing, FaultTexts& faults) {
  const double diameter =
      2.0 * *std::max_element(packing.particles.radius.begin(), packing.particles.radius.end());
  const Vec3& size = packing.cell.size;
  const double smallest = size.minCoeff();
  if (smallest < diameter * (1.0 - 1e-9)) {
    faults.push_back(fmt::format(
        "cell.size: an edge of {:.6g} m is smaller than the largest particle; allowed: at least {:.6g} m",
        smallest, diameter));
    return;
  }
  const double share = filled_share(packing);
  if (share > 1.0) {
    faults.push_back(fmt::format(
        "cell.size: the particles fill {:.4g} of the cell [{:.6g}, {:.6g}, {:.6g}] m; allowed: at "
        "most 1, so a larger cell or fewer particles",
        share, size.x(), size.y(), size.z()));
  }
}

// Distances are differences of coordinates, and necks follow them.
void check_round_off(const config::Case& whole, const Particles& particles, FaultTexts& faults) {
  double farthest = 0.0;
  for (const Vec3& x : particles.position) farthest = std::max(farthest, x.cwiseAbs().maxCoeff());
  const double smallest = *std::min_element(particles.radius.begin(), particles.radius.end());
  const double allowed = coarsest_round_off * smallest / std::numeric_limits<double>::epsilon();
  if (farthest <= allowed) return;
  faults.push_back(
      fmt::format("{}: a coordinate of {:.6g} m is too large for a radius of {:.6g} m: its round-off would "
                  "show in the necks; "
                  "allowed: at most {:.3g} m, so move the particles towards the origin",
                  origin_of(whole), farthest, smallest, allowed));
}

// Largest extent of the centres along an axis [m].
double width_of(const Particles& particles) {
  Vec3 least = particles.position.front(), most = least;
  for (const Vec3& x : particles.position) {
    least = least.cwiseMin(x);
    most = most.cwiseMax(x);
  }
  return (most - least).maxCoeff();
}

double mean_radius_of(const Particles& particles) {
  return std::accumulate(particles.radius.begin(), particles.radius.end(), 0.0) /
         static_cast<double>(particles.size());
}

bool has_force(const Particles& particles) {
  return std::any_of(particles.force.begin(), particles.force.end(),
                     [](const Vec3& f) { return !f.isZero(0.0); });
}

// Whether something other than necks can bring particles together.
bool is_compressed(const config::Case& whole, const State& state) {
  if (has_force(state.particles)) return true;
  if (!state.cell.periodic) return false;
  if (whole.cell.strain_rate) return whole.cell.strain_rate->minCoeff() < 0.0;
  return whole.cell.stress && whole.cell.stress->minCoeff() < 0.0;
}

// When the furnace, which gets hotter than T [K], first does so [s].
double first_time_at(const Heating& heating, double T) {
  double now = heating.start, time = 0.0;
  for (const integrate::Ramp& ramp : heating.ramps) {
    const double end = now + ramp.rate * ramp.duration;
    if (now > T || end > T) return now > T ? time : time + (T - now) / ramp.rate;
    now = end;
    time += ramp.duration;
  }
  return time;
}

}  // namespace

void check_spheres(const config::Case& whole, const generate::Packing& packing, FaultTexts& faults) {
  if (packing.cell.periodic) check_cell(packing, faults);
  check_round_off(whole, packing.particles, faults);
  if (!faults.empty()) return;  // the search for pairs needs a sound cell
  Counted inside(faults);
  const Particles& particles = packing.particles;
  for (const neighbor::Pair& pair : neighbor::find_pairs(particles, packing.cell, 0.0)) {
    const auto i = static_cast<std::size_t>(pair.i), j = static_cast<std::size_t>(pair.j);
    const double distance =
        packing.cell.separation(particles.position[i], particles.position[j], pair.image).norm();
    const double larger = std::max(particles.radius[i], particles.radius[j]);
    if (distance >= larger) continue;
    inside.add(
        fmt::format("{}: particles {} and {} are {:.6g} m apart, so the centre of one is inside the "
                    "other; allowed: at least {:.6g} m",
                    origin_of(whole), pair.i, pair.j, distance, larger));
  }
}

void check_contacts(const config::Case& whole, const State& state, FaultTexts& faults) {
  const Contacts& contacts = state.contacts;
  if (contacts.size() == 0 && !is_compressed(whole, state)) {
    faults.push_back(fmt::format(
        "{}: no two particles touch and nothing would bring them together, so nothing can sinter; "
        "allowed: a packing with contacts, or a load (it is {:.6g} m wide, its mean radius is {:.6g} m: are "
        "the units right?)",
        origin_of(whole), width_of(state.particles), mean_radius_of(state.particles)));
  }
  if (!whole.packing.contacts) return;
  Counted apart(faults);
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    const auto i = static_cast<std::size_t>(contacts.i[k]), j = static_cast<std::size_t>(contacts.j[k]);
    const double smaller = std::min(state.particles.radius[i], state.particles.radius[j]);
    if (-contacts.overlap[k] <= widest_neck_gap * smaller) continue;
    const auto [first, second] = std::minmax(state.particles.id[i], state.particles.id[j]);
    apart.add(fmt::format(
        "{}: the contact of particles {} and {} bridges a gap of {:.6g} m; allowed: at most a "
        "tenth of the smaller radius, {:.6g} m",
        whole.packing.contacts->string(), first, second, -contacts.overlap[k], widest_neck_gap * smaller));
  }
}

void check_stop(const config::Case& whole, const observe::Reference& reference, double density,
                FaultTexts& faults) {
  if (whole.stop.time && whole.method.time_step &&
      *whole.stop.time / *whole.method.time_step > most_fixed_steps) {
    faults.push_back(
        fmt::format("method.time_step: {:.6g} s makes {:.3g} steps to stop.time = {:.6g} s; allowed: at "
                    "least {:.6g} s, or \"auto\"",
                    *whole.method.time_step, *whole.stop.time / *whole.method.time_step, *whole.stop.time,
                    *whole.stop.time / most_fixed_steps));
  }
  if (!whole.stop.relative_density) return;
  const double target = *whole.stop.relative_density;
  if (std::isnan(density) && reference.core.members.size() >= observe::smallest_core) {
    faults.push_back(fmt::format(
        "stop.relative_density: {:.6g} cannot be measured: this free body has no volume; allowed: stop.time",
        target));
  } else if (std::isnan(density)) {
    faults.push_back(
        fmt::format("stop.relative_density: {:.6g} cannot be measured: the core of this free body has {} "
                    "particles, {} are needed; allowed: stop.time",
                    target, reference.core.members.size(), observe::smallest_core));
  } else if (density >= target) {
    faults.push_back(
        fmt::format("stop.relative_density: {:.6g} is reached before the start; allowed: above the "
                    "packing's {:.6g}, at most 1",
                    target, density));
  }
}

std::vector<std::string> find_warnings(const config::Case& whole, const State& state, double density) {
  std::vector<std::string> warnings;
  const double sine = std::sin(0.5 * whole.material.dihedral_angle);
  std::size_t capped = 0;
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    const double r_i = state.particles.radius[static_cast<std::size_t>(state.contacts.i[k])];
    const double r_j = state.particles.radius[static_cast<std::size_t>(state.contacts.j[k])];
    if (equivalent_radius(r_i, r_j) * sine > std::min(r_i, r_j)) ++capped;
  }
  if (capped > 0 && whole.contact.equilibrium_radius == config::EquilibriumRadius::equivalent) {
    warnings.push_back(fmt::format(
        "contact.equilibrium_radius: for {} of {} contacts R sin(psi/2) exceeds the smaller particle, "
        "whose radius then ends the growth; \"smaller\" would give another answer",
        capped, state.contacts.size()));
  }
  if (std::isnan(density) && whole.output.every_density && !whole.output.every_time &&
      !whole.output.every_steps) {
    warnings.push_back(fmt::format(
        "output.every_density: this free body has fewer than {} particles in its core and no density, "
        "so only the first and the last state are written; output.every_time gives more",
        observe::smallest_core));
  }
  return warnings;
}

std::optional<std::string> warn_of_melting(const config::Case& whole, const Heating& heating) {
  const std::optional<double> melting = whole.material.melting_temperature;
  if (!melting || heating.hottest <= *melting) return std::nullopt;
  const double passed = first_time_at(heating, *melting);
  if (whole.stop.time && *whole.stop.time <= passed) return std::nullopt;
  return fmt::format(
      "temperature: the furnace passes {:.6g} K, where the material melts (material.melting_temperature), at "
      "{:.6g} s on its way to {:.6g} K; only sintering of the solid is computed, so what follows means "
      "nothing",
      *melting, passed, heating.hottest);
}

std::optional<std::string> warn_of_inertia(const config::Case& whole, const State& state, double delta_b) {
  if (whole.method.name != config::MethodName::verlet || state.particles.size() == 0) return std::nullopt;
  const integrate::VerletSettings settings = verlet_settings_of(whole);
  double spoiled = 0.0;
  for (std::size_t n = 0; n < state.particles.size(); ++n) {
    const double radius = state.particles.radius[n];
    const double pull = contact::attraction_force(settings.law, {radius, radius}, 0.0);
    const double mass = settings.density_factor * state.particles.mass[n];
    spoiled = std::max(spoiled, integrate::inertial_neck_ratio(delta_b, pull, mass, radius));
  }
  // Density and rearrangement are spared while the youngest neck is well above (docs/theory.md, section 7).
  const double youngest = settings.law.birth_neck_ratio;
  if (spoiled <= 0.8 * youngest) return std::nullopt;
  return fmt::format(
      "method.density_factor: {:.3g} makes inertia govern necks below a neck ratio of {:.3g}; new necks have "
      "{:.3g} "
      "(contact.birth_neck_ratio), so their growth, and rearrangement with it, is not that of the real mass",
      settings.density_factor, spoiled, youngest);
}

}  // namespace frit::run
