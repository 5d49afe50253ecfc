#include "analyze/analysis.hpp"

#include <fmt/core.h>

#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "analyze/histogram.hpp"
#include "analyze/same_particles.hpp"
#include "analyze/snapshots.hpp"
#include "core/error.hpp"
#include "io/json.hpp"
#include "io/series.hpp"
#include "io/text.hpp"
#include "observe/fields.hpp"
#include "observe/network_row.hpp"
#include "run/folders.hpp"

namespace frit::analyze {
namespace {

namespace fs = std::filesystem;

// Columns of series.csv that only the run knows.
constexpr std::array<const char*, 4> run_columns{"time_step [s]", "steps", "newton_iterations",
                                                 "solver_iterations"};

// Fields of which a distribution is told, with their names there.
constexpr std::array<std::array<const char*, 2>, 11> told_fields{{{"coordination", "degree"},
                                                                  {"rearrangement_deviation", ""},
                                                                  {"rearrangement_d2min", ""},
                                                                  {"contacts_gained", ""},
                                                                  {"contacts_lost", ""},
                                                                  {"neck_angle_change [rad]", ""},
                                                                  {"own_rotation [rad]", "rotation [rad]"},
                                                                  {"neck_ratio", ""},
                                                                  {"rolling [rad]", ""},
                                                                  {"sliding", ""},
                                                                  {"twisting [rad]", ""}}};

void add_histogram(nlohmann::json& all, const std::string& name, const std::vector<double>& values) {
  const Histogram histogram = make_histogram(values);
  if (!histogram.counts.empty()) all[name] = json_of(histogram);
}

void add_told(nlohmann::json& all, const std::vector<observe::Field>& fields) {
  for (const observe::Field& field : fields) {
    for (const auto& [name, told] : told_fields) {
      if (field.name == name) add_histogram(all, *told == '\0' ? name : told, field.values);
    }
  }
}

std::optional<std::size_t> index_in(const std::string& reference, std::size_t count, const char* what) {
  const auto number = reference.empty() ? std::optional<std::int64_t>(0) : io::parse_whole(reference);
  if (!number) return std::nullopt;
  if (*number >= 0 && static_cast<std::size_t>(*number) < count) return static_cast<std::size_t>(*number);
  throw InputError(fmt::format("--reference: there is no {} {}; allowed: 0 to {}", what, *number, count - 1));
}

void check_same(const Moment& reference, const Moment& moment) {
  const std::vector<std::string> faults = differences_of_ids(reference, moment);
  if (!faults.empty()) throw InputError(faults);
}

Moment reference_from_file(const fs::path& path, const Moment& start) {
  Moment reference = read_particles(path);
  reference.name = path.string();
  check_same(reference, start);
  if (reference.state.cell.periodic != start.state.cell.periodic) {
    throw InputError(
        fmt::format("--reference: {} {}, the run {}; allowed: a file with the same kind of cell (.vtp, .xyz "
                    "and .dump carry it)",
                    path.string(), reference.state.cell.periodic ? "has a periodic cell" : "has no cell",
                    start.state.cell.periodic ? "has one" : "has none"));
  }
  if (start.state.cell.periodic) unwrap(start.state, reference.state);
  return reference;
}

void write_rows(const fs::path& path, const std::vector<Findings>& findings, observe::Row Findings::*part) {
  std::vector<std::string> columns;
  for (const observe::Column& column : findings.front().*part) columns.push_back(column.name);
  io::SeriesWriter writer(path, columns);
  for (const Findings& found : findings) {
    std::vector<double> values;
    for (const observe::Column& column : found.*part) values.push_back(column.value);
    writer.write_row(values);
  }
}

}  // namespace

Findings look_at(const observe::Reference& reference, const Moment& moment) {
  const observe::NeckLaw law = moment.necks.view();
  Findings found;
  found.row = observe::observe_row(reference, moment.state, law);
  for (const char* column : run_columns) found.row.push_back({column, observe::no_value});
  const double density = observe::value_of(found.row, "relative_density");
  found.network = observe::observe_network(moment.state, law, density);
  nlohmann::json distributions = nlohmann::json::object();
  add_told(distributions, observe::particle_fields(reference, moment.state));
  add_told(distributions, observe::contact_fields(moment.state, law));
  add_histogram(distributions, "normal_force_ratio", observe::relative_forces(moment.state.contacts));
  found.distributions = {{"file", moment.name},
                         {"time [s]", moment.state.time},
                         {"relative_density", density},
                         {"distributions", std::move(distributions)}};
  return found;
}

std::vector<Findings> analyze_result(const fs::path& folder, const std::string& reference) {
  const std::vector<SnapshotFiles> files = list_snapshots(folder);
  const auto number = index_in(reference, files.size(), "snapshot");
  const Moment start = read_snapshot(files[number.value_or(0)]);
  const Moment base = number ? start : reference_from_file(reference, start);
  const observe::Reference since = observe::take_reference(base.state);
  std::vector<Findings> findings;
  for (const SnapshotFiles& snapshot : files) {
    const Moment moment = read_snapshot(snapshot);
    check_same(base, moment);
    findings.push_back(look_at(since, moment));
  }
  return findings;
}

std::vector<Findings> analyze_centres(const Centres& centres, const std::string& reference) {
  const std::vector<Moment> moments = read_centres(centres);
  const auto number = index_in(reference, moments.size(), "time");
  if (!number)
    throw InputError("--reference: with --centres allowed: the number of one of its files, from 0");
  const observe::Reference since = observe::take_reference(moments[*number].state);
  std::vector<Findings> findings;
  for (const Moment& moment : moments) findings.push_back(look_at(since, moment));
  return findings;
}

void write_findings(const fs::path& folder, const std::vector<Findings>& findings) {
  run::make_folder(folder);
  write_rows(folder / "series.csv", findings, &Findings::row);
  write_rows(folder / "network.csv", findings, &Findings::network);
  nlohmann::json all = {
      {"format", "frit distributions"}, {"version", 1}, {"moments", nlohmann::json::array()}};
  for (const Findings& found : findings) all["moments"].push_back(found.distributions);
  io::write_json(folder / "distributions.json", all);
}

}  // namespace frit::analyze
