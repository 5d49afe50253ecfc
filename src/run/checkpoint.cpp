#include "run/checkpoint.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <optional>
#include <system_error>
#include <utility>

#include "config/case_writer.hpp"
#include "core/error.hpp"
#include "io/cbor_map.hpp"
#include "io/state_arrays.hpp"
#include "io/text.hpp"
#include "io/write_file.hpp"
#include "run/machine.hpp"

namespace frit::run {
namespace {

namespace fs = std::filesystem;

// The entries of a progress, each named once for both ways.
template <class P, class Visit>
void visit_progress(P& progress, const Visit& visit) {
  visit("density", progress.density);
  visit("proposed_duration", progress.proposed_duration);
  visit("output_level", progress.output_level);
  visit("changed_density", progress.changed_density);
  visit("changed_theta", progress.changed_theta);
  visit("row_step", progress.row_step);
  auto& totals = progress.totals;
  visit("steps", totals.steps);
  visit("rejected_steps", totals.rejected_steps);
  visit("fitting_attempts", totals.fitting_attempts);
  visit("newton_iterations", totals.newton_iterations);
  visit("solver_iterations", totals.solver_iterations);
  visit("linear_solves.block_jacobi", totals.linear_solves.block_jacobi);
  visit("linear_solves.with_coarse_level", totals.linear_solves.with_coarse_level);
  visit("linear_solves.factored", totals.linear_solves.factored);
  visit("linear_solves.in_double", totals.linear_solves.in_double);
  visit("last_duration", totals.last_duration);
  visit("largest_residual", totals.largest_residual);
  visit("weighted_error", totals.weighted_error);
  visit("progress", totals.progress);
  visit("work.released", totals.work.released);
  visit("work.cell", totals.work.cell);
  visit("work.load", totals.work.load);
  visit("work.approach", totals.work.approach);
  visit("work.sliding", totals.work.sliding);
  visit("work.bending", totals.work.bending);
  visit("work.inertia", totals.work.inertia);
  visit("work.imbalance", totals.work.imbalance);
}

void take(const io::CborMap& map, const std::string& name, double& value) { value = map.real(name); }
template <class Whole>
void take(const io::CborMap& map, const std::string& name, Whole& value) {
  value = static_cast<Whole>(map.whole(name));
}

void put(io::CborMap& map, const std::string& name, double value) { map.put(name, value); }
template <class Whole>
void put(io::CborMap& map, const std::string& name, Whole value) {
  map.put(name, static_cast<std::int64_t>(value));
}

void check_whole(const Checkpoint& checkpoint) {
  const auto check = [](bool good, const char* what) {
    if (!good) throw InputError(what);
  };
  const Particles &start = checkpoint.start.particles, &now = checkpoint.state.particles;
  check(now.size() > 0 && start.id == now.id, "the particles of the start and of now differ");
  check(checkpoint.start.cell.periodic == checkpoint.state.cell.periodic, "the cells differ in kind");
  check(checkpoint.series.rows > 0 && checkpoint.series.bytes > 0, "no row of the series belongs to it");
  check(checkpoint.progress.totals.steps >= 0, "the number of steps is negative");
}

struct Found {
  std::optional<Checkpoint> checkpoint;
  std::string fault;  // why it cannot be used
};

Found read_one(const fs::path& path) {
  const std::string bytes = io::read_file_whole(path);
  const io::Unsealed unsealed = io::unseal(bytes, checkpoint_kind);
  switch (unsealed.state) {
    case io::SealState::foreign:
      return {{}, fmt::format("{}: is no checkpoint of frit; frit run --force starts anew", path.string())};
    case io::SealState::damaged:
      return {
          {},
          fmt::format("{}: is damaged: its checksum does not fit its {} bytes", path.string(), bytes.size())};
    case io::SealState::other_version:
      throw InputError(fmt::format(
          "{}: is written in version {} of the format, this program reads version {}; go on with the program "
          "that wrote it",
          path.string(), unsealed.version, checkpoint_kind.version));
    case io::SealState::intact:
      break;
  }
  try {
    return {parse_checkpoint(unsealed.contents), ""};
  } catch (const InputError& error) {
    return {{}, fmt::format("{}: is damaged: {}", path.string(), error.what())};
  }
}

bool is_file(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error);
}

// So that the next checkpoint does not put the damaged one in the place of this one.
void put_in_place(const fs::path& previous, const fs::path& last) {
  std::error_code error;
  fs::rename(previous, last, error);
  if (!error) return;
  throw MachineError(fmt::format("{}: moving it into the place of {} failed: {}; check the permissions",
                                 previous.string(), last.filename().string(), error.message()));
}

}  // namespace

std::string checkpoint_bytes(const Setup& setup, const Standing& now, const io::SeriesExtent& series) {
  io::CborMap map;
  map.put("program", std::string(version()));
  map.put("case", config::write_case(setup.whole, version()));
  io::put_state(map, "start.", setup.state);
  io::put_state(map, "now.", now.state);
  visit_progress(now.progress, [&](const char* name, const auto& value) { put(map, name, value); });
  map.put("series.rows", series.rows);
  map.put("series.bytes", series.bytes);
  map.put("series.checksum", std::int64_t{series.checksum});
  std::string bytes(io::seal_bytes, '\0');
  map.move_to(bytes);
  io::seal(bytes, checkpoint_kind);
  return bytes;
}

Checkpoint parse_checkpoint(std::string_view contents) {
  const io::CborMap map = io::CborMap::parse(contents);
  Checkpoint checkpoint;
  checkpoint.program = map.text("program");
  checkpoint.case_text = map.text("case");
  checkpoint.start = io::take_state(map, "start.");
  checkpoint.state = io::take_state(map, "now.");
  visit_progress(checkpoint.progress, [&](const char* name, auto& value) { take(map, name, value); });
  take(map, "series.rows", checkpoint.series.rows);
  take(map, "series.bytes", checkpoint.series.bytes);
  take(map, "series.checksum", checkpoint.series.checksum);
  check_whole(checkpoint);
  return checkpoint;
}

void write_checkpoint(const fs::path& folder, const std::string& bytes) {
  io::write_file_keeping(folder / checkpoint_name, folder / previous_checkpoint_name, bytes);
}

Checkpoint load_checkpoint(const fs::path& folder, std::vector<std::string>& notes) {
  const fs::path last = folder / checkpoint_name, previous = folder / previous_checkpoint_name;
  std::vector<std::string> faults;
  for (const fs::path& path : {last, previous}) {
    if (!is_file(path)) continue;
    Found found = read_one(path);
    if (!found.checkpoint) {
      faults.push_back(found.fault);
      continue;
    }
    if (path == previous) {
      notes.push_back(faults.empty() ? fmt::format("{}: is missing", last.string()) : faults.front());
      notes.back() += "; going on from the checkpoint before it";
      put_in_place(previous, last);
    }
    return std::move(*found.checkpoint);
  }
  if (!faults.empty()) throw InputError(faults);
  throw InputError(
      fmt::format("{}: holds no checkpoint to go on from; frit run --force starts anew", folder.string()));
}

}  // namespace frit::run
