#include "io/contacts_csv.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include "io/csv_reader.hpp"

namespace frit::io {

namespace {

struct ContactColumns {
  std::size_t i = 0, j = 0;
  std::optional<std::size_t> neck_radius;
  double units_per_metre = 1.0;  // of the neck radius
};

ContactColumns find_columns(const CsvReader& csv) {
  FaultList faults;
  ContactColumns columns;
  columns.i = csv.require("i", faults).value_or(0);
  columns.j = csv.require("j", faults).value_or(0);
  columns.neck_radius = csv.find("neck_radius", faults);
  if (columns.neck_radius) columns.units_per_metre = csv.units_per_metre(*columns.neck_radius, faults);
  faults.throw_if_any();
  return columns;
}

// The particle that a cell names, or nothing after a fault.
std::optional<std::int32_t> read_particle(const CsvReader& csv, std::size_t column,
                                          std::size_t particle_count, FaultList& faults) {
  const auto value = csv.whole(column, faults);
  if (!value) return std::nullopt;
  if (*value >= 0 && static_cast<std::size_t>(*value) < particle_count)
    return static_cast<std::int32_t>(*value);
  const auto allowed = particle_count == 0 ? std::string("there are none")
                                           : fmt::format("allowed: 0 to {}", particle_count - 1);
  faults.add(fmt::format("{}: column '{}': there is no particle {}; {}", csv.where(csv.line()),
                         csv.columns()[column].name, *value, allowed));
  return std::nullopt;
}

double read_neck_radius(const CsvReader& csv, const ContactColumns& columns, FaultList& faults) {
  const double neck_radius = csv.real(*columns.neck_radius, faults) / columns.units_per_metre;
  if (neck_radius <= 0.0) {
    faults.add(fmt::format("{}: column 'neck_radius': {} m is not positive; a neck radius must be > 0",
                           csv.where(csv.line()), neck_radius));
  }
  return neck_radius;
}

}  // namespace

ContactTable read_contacts_csv(const std::filesystem::path& path, std::size_t particle_count) {
  CsvReader csv(path);
  const auto columns = find_columns(csv);
  FaultList faults;
  ContactTable contacts;
  std::map<std::pair<std::int32_t, std::int32_t>, std::size_t> line_of_pair;
  while (csv.next_row(faults)) {
    const auto i = read_particle(csv, columns.i, particle_count, faults);
    const auto j = read_particle(csv, columns.j, particle_count, faults);
    if (columns.neck_radius) contacts.neck_radius.push_back(read_neck_radius(csv, columns, faults));
    if (!i || !j) continue;
    contacts.i.push_back(*i);
    contacts.j.push_back(*j);
    if (*i == *j) {
      faults.add(
          fmt::format("{}: columns 'i', 'j': particle {} cannot touch itself", csv.where(csv.line()), *i));
      continue;
    }
    const auto [known, added] = line_of_pair.try_emplace(std::minmax(*i, *j), csv.line());
    if (!added) {
      faults.add(fmt::format("{}: columns 'i', 'j': the contact of {} and {} is already listed at {}",
                             csv.where(csv.line()), *i, *j, csv.where(known->second)));
    }
  }
  faults.throw_if_any();
  return contacts;
}

}  // namespace frit::io
