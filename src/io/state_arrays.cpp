#include "io/state_arrays.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace frit::io {
namespace {

static_assert(sizeof(Vec3) == 24 && sizeof(Quat) == 32 && sizeof(Image) == 3);
// What is added to a state must be added below.
constexpr std::size_t array_bytes = sizeof(std::vector<double>);
static_assert(sizeof(Particles) == 9 * array_bytes && sizeof(Cracks) == 4 * array_bytes);

// The arrays of a state, each named once for both ways. `visit` gets a name and a vector.
template <class Part, class Visit>
void visit_particles(Part& p, const Visit& visit) {
  visit("particles.id", p.id);
  visit("particles.position", p.position);
  visit("particles.radius", p.radius);
  visit("particles.mass", p.mass);
  visit("particles.velocity", p.velocity);
  visit("particles.spin", p.spin);
  visit("particles.orientation", p.orientation);
  visit("particles.force", p.force);
  visit("particles.fixed", p.fixed);
}

template <class Part, class Visit>
void visit_contacts(Part& c, const Visit& visit) {
  Contacts::for_each_array(
      [&](const char* name, auto array) { visit((std::string("contacts.") + name).c_str(), c.*array); });
}

template <class Part, class Visit>
void visit_cracks(Part& c, const Visit& visit) {
  visit("cracks.i", c.i);
  visit("cracks.j", c.j);
  visit("cracks.image", c.image);
  visit("cracks.overlap_when_parted", c.overlap_when_parted);
}

std::vector<Vec3> whole_vectors(const State& state) {
  return {state.cell.size, state.cell_rate, state.cell_strain};
}
std::vector<double> whole_numbers(const State& state) {
  return {state.time, state.temperature, state.last_step, state.theta};
}

void check(bool good, const std::string& prefix, const char* what) {
  if (!good) throw InputError(prefix + what);
}

// A file's length vouches for the numbers of entries, which are those of these three.
constexpr auto particle_counter = "particles.radius", contact_counter = "contacts.birth_neck_radius",
               crack_counter = "cracks.overlap_when_parted";

template <class Pairs>
bool are_rows(const Pairs& pairs, std::size_t rows) {
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    if (pairs.i[k] < 0 || pairs.j[k] < pairs.i[k] || std::cmp_greater_equal(pairs.j[k], rows)) return false;
  }
  return true;
}

bool are_ids_of_rows(std::vector<std::int64_t> ids) {
  std::ranges::sort(ids);
  for (std::size_t row = 0; row < ids.size(); ++row) {
    if (std::cmp_not_equal(ids[row], row)) return false;
  }
  return true;
}

bool is_finite(const std::vector<double>& numbers) {
  return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}
bool is_finite(const std::vector<Vec3>& vectors) {
  return std::ranges::all_of(vectors, [](const Vec3& vector) { return vector.allFinite(); });
}

void check_state(const State& state, const std::string& prefix) {
  const Particles& p = state.particles;
  check(are_ids_of_rows(p.id), prefix, "particles.id: not each row of the packing once");
  check(is_finite(p.position) && is_finite(p.radius) && is_finite(p.mass), prefix, "particles: not finite");
  check(std::ranges::all_of(p.radius, [](double r) { return r > 0.0; }), prefix, "particles.radius: not > 0");
  check(are_rows(state.contacts, p.size()), prefix, "contacts: join rows that are not there");
  check(are_rows(state.cracks, p.size()), prefix, "cracks: join rows that are not there");
  check(is_finite(state.contacts.neck_radius_squared) && is_finite(state.contacts.overlap), prefix,
        "contacts: not finite");
  check(is_finite(whole_numbers(state)) && is_finite(whole_vectors(state)), prefix,
        "cell or clock: not finite");
  check(!state.cell.periodic || state.cell.size.minCoeff() > 0.0, prefix, "cell.size: not > 0");
}

}  // namespace

void put_state(CborMap& map, const std::string& prefix, const State& state) {
  const auto put = [&](const char* name, const auto& values) { map.put_array(prefix + name, values); };
  visit_particles(state.particles, put);
  visit_contacts(state.contacts, put);
  visit_cracks(state.cracks, put);
  const auto put_in_full = [&](const char* name, const std::vector<double>& values) {
    map.put_array(prefix + name, values, CborMap::Zeros::in_full);
  };
  put_in_full(particle_counter, state.particles.radius);
  put_in_full(contact_counter, state.contacts.birth_neck_radius);
  put_in_full(crack_counter, state.cracks.overlap_when_parted);
  map.put(prefix + "cell.periodic", std::int64_t{state.cell.periodic});
  put("cell.size, rate, strain", whole_vectors(state));
  put("time, temperature, last_step, theta", whole_numbers(state));
}

State take_state(const CborMap& map, const std::string& prefix) {
  State state;
  std::size_t count = 0;
  const auto take = [&](const char* name, auto& values) {
    values = map.array<typename std::remove_reference_t<decltype(values)>::value_type>(prefix + name, count);
  };
  count = map.count(prefix + particle_counter, sizeof(double));
  visit_particles(state.particles, take);
  count = map.count(prefix + contact_counter, sizeof(double));
  visit_contacts(state.contacts, take);
  count = map.count(prefix + crack_counter, sizeof(double));
  visit_cracks(state.cracks, take);
  state.cell.periodic = map.whole(prefix + "cell.periodic") != 0;
  const auto vectors = map.array<Vec3>(prefix + "cell.size, rate, strain", 3);
  state.cell.size = vectors[0];
  state.cell_rate = vectors[1];
  state.cell_strain = vectors[2];
  const auto numbers = map.array<double>(prefix + "time, temperature, last_step, theta", 4);
  state.time = numbers[0];
  state.temperature = numbers[1];
  state.last_step = numbers[2];
  state.theta = numbers[3];
  check_state(state, prefix);
  return state;
}

}  // namespace frit::io
