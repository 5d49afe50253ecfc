#include "analyze/same_particles.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <numeric>

#include "core/error.hpp"

namespace frit::analyze {
namespace {

constexpr std::size_t most_ids_told = 5;

std::string missing_text(const Moment& there, const Moment& here) {
  std::vector<std::int64_t> missing;
  std::ranges::set_difference(there.state.particles.id, here.state.particles.id, std::back_inserter(missing));
  if (missing.empty()) return {};
  std::string ids;
  for (std::size_t n = 0; n < std::min(missing.size(), most_ids_told); ++n)
    ids += fmt::format("{}{}", n == 0 ? "" : ", ", missing[n]);
  if (missing.size() > most_ids_told) ids += ", ...";
  return fmt::format("{}: lacks {} of the {} particles of {} (ids {})", here.name, missing.size(),
                     there.state.particles.size(), there.name, ids);
}

template <class Value>
void keep(std::vector<Value>& values, const std::vector<std::size_t>& rows) {
  if (values.empty()) return;
  std::vector<Value> kept;
  kept.reserve(rows.size());
  for (const std::size_t row : rows) kept.push_back(values[row]);
  values.swap(kept);
}

void keep_contacts(Moment& moment, const std::vector<std::int32_t>& new_row) {
  Contacts& contacts = moment.state.contacts;
  std::vector<std::size_t> rows;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    if (new_row[contacts.i[k]] >= 0 && new_row[contacts.j[k]] >= 0) rows.push_back(k);
  }
  keep(contacts.i, rows);
  keep(contacts.j, rows);
  for (auto* ends : {&contacts.i, &contacts.j})
    for (std::int32_t& row : *ends) row = new_row[row];
  keep(contacts.image, rows);
  keep(contacts.sliding_velocity, rows);
  for (auto* values :
       {&contacts.neck_radius_squared, &contacts.overlap, &contacts.birth_neck_radius, &contacts.birth_time,
        &contacts.equilibrium_force, &contacts.normal_force, &contacts.approach_velocity,
        &contacts.rolling_path, &contacts.twisting_path, &contacts.sliding_path, &moment.necks.neck_radius,
        &moment.necks.normal_resistance, &moment.necks.sliding_resistance}) {
    keep(*values, rows);
  }
}

void keep_particles(Moment& moment, const std::vector<std::int64_t>& ids) {
  const Particles& all = moment.state.particles;
  std::vector<std::int32_t> new_row(all.size(), -1);
  Particles kept;
  for (std::size_t row = 0; row < all.size(); ++row) {
    if (!std::ranges::binary_search(ids, all.id[row])) continue;
    new_row[row] = static_cast<std::int32_t>(kept.size());
    kept.add(all.position[row], all.radius[row]);
    kept.id.back() = all.id[row];
    kept.velocity.back() = all.velocity[row];
    kept.spin.back() = all.spin[row];
    kept.orientation.back() = all.orientation[row];
  }
  keep_contacts(moment, new_row);
  moment.state.particles = std::move(kept);
}

}  // namespace

std::vector<std::string> differences_of_ids(const Moment& first, const Moment& other) {
  std::vector<std::string> faults;
  for (const std::string& fault : {missing_text(first, other), missing_text(other, first)}) {
    if (!fault.empty()) faults.push_back(fault);
  }
  return faults;
}

void keep_common_particles(std::vector<Moment>& moments) {
  if (moments.empty()) return;
  std::vector<std::int64_t> common = moments.front().state.particles.id;
  for (const Moment& moment : moments) {
    std::vector<std::int64_t> both;
    std::ranges::set_intersection(common, moment.state.particles.id, std::back_inserter(both));
    common.swap(both);
  }
  if (common.empty()) throw InputError("--common: no particle (id) is in all files");
  for (Moment& moment : moments) keep_particles(moment, common);
}

void renumber(std::vector<Moment>& moments) {
  for (Moment& moment : moments)
    std::iota(moment.state.particles.id.begin(), moment.state.particles.id.end(), std::int64_t{0});
}

void unwrap(const State& start, State& reference) {
  for (std::size_t row = 0; row < reference.particles.size(); ++row) {
    Vec3& x = reference.particles.position[row];
    for (int axis = 0; axis < 3; ++axis) {
      const double edge = reference.cell.size[axis];
      const double there = start.particles.position[row][axis] * edge / start.cell.size[axis];
      x[axis] += std::round((there - x[axis]) / edge) * edge;
    }
  }
}

}  // namespace frit::analyze
