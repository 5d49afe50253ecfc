#include "analyze/snapshots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <string>
#include <string_view>
#include <system_error>
#include <tuple>
#include <utility>
#include <variant>

#include "core/error.hpp"
#include "io/frame_files.hpp"
#include "io/pvd.hpp"
#include "io/vtp.hpp"
#include "observe/statistics.hpp"

namespace frit::analyze {
namespace {

namespace fs = std::filesystem;
using observe::no_value;

// The numbers of an array, or NaN for each where there is no such array.
std::vector<double> values_of(const std::vector<io::NamedArray>& arrays, std::string_view name,
                              std::size_t count) {
  for (const io::NamedArray& array : arrays) {
    const auto* values = std::get_if<std::vector<double>>(&array.values);
    if (array.name == name && values != nullptr && values->size() == count) return *values;
  }
  return std::vector<double>(count, no_value);
}

std::vector<Vec3> vectors_of(const std::vector<io::NamedArray>& arrays, std::string_view name,
                             std::size_t count) {
  const std::vector<double> values = values_of(arrays, name, 3 * count);
  std::vector<Vec3> vectors;
  vectors.reserve(count);
  for (std::size_t n = 0; n < count; ++n) vectors.emplace_back(&values[3 * n]);
  return vectors;
}

template <class Value>
std::vector<Value> picked(const std::vector<Value>& values, const std::vector<std::size_t>& order) {
  std::vector<Value> result;
  result.reserve(order.size());
  for (const std::size_t row : order) result.push_back(values[row]);
  return result;
}

Quat orientation_of(const Vec3& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) return Quat::Identity();
  return Quat(Eigen::AngleAxisd(angle, rotation / angle));
}

std::vector<std::int32_t> rows_of(const io::PolyData& data, std::string_view name, const State& state,
                                  const std::string& file) {
  const auto found = std::ranges::find_if(data.cell_arrays, [&](const auto& array) {
    return array.name == name && std::holds_alternative<std::vector<std::int64_t>>(array.values);
  });
  if (found == data.cell_arrays.end())
    throw InputError(fmt::format("{}: the cell array '{}' (Int64) is missing", file, name));
  const std::vector<std::int64_t>& ids = state.particles.id;
  std::vector<std::int32_t> rows;
  for (const std::int64_t id : std::get<std::vector<std::int64_t>>(found->values)) {
    const auto place = std::ranges::lower_bound(ids, id);
    if (place == ids.end() || *place != id) {
      throw InputError(fmt::format("{}: cell array '{}': there is no particle {}", file, name, id));
    }
    rows.push_back(static_cast<std::int32_t>(place - ids.begin()));
  }
  return rows;
}

// The copy of j whose centre the segment of a contact ends at.
Image image_at(const State& state, const Vec3& end, const Vec3& x_j) {
  Image image{0, 0, 0};
  if (!state.cell.periodic) return image;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    image[axis] = static_cast<std::int8_t>(std::lround((end[axis] - x_j[axis]) / state.cell.size[axis]));
  }
  return image;
}

// Geometry and history of the contacts; their order is that of the file, which is that of (i, j, image).
void fill_contacts(const io::PolyData& data, const std::string& file, State& state) {
  Contacts& contacts = state.contacts;
  const std::size_t count = data.points.size() / 2;
  contacts.resize(count);
  contacts.i = rows_of(data, "i", state, file);
  contacts.j = rows_of(data, "j", state, file);
  const auto& arrays = data.cell_arrays;
  contacts.normal_force = values_of(arrays, "normal_force [N]", count);
  contacts.approach_velocity = values_of(arrays, "approach_velocity [m/s]", count);
  contacts.sliding_velocity = vectors_of(arrays, "sliding_velocity [m/s]", count);
  contacts.rolling_path = values_of(arrays, "rolling [rad]", count);
  contacts.twisting_path = values_of(arrays, "twisting [rad]", count);
  contacts.sliding_path = values_of(arrays, "sliding", count);
  contacts.birth_time = values_of(arrays, "age [s]", count);
  const Particles& particles = state.particles;
  for (std::size_t k = 0; k < count; ++k) {
    const auto i = static_cast<std::size_t>(contacts.i[k]), j = static_cast<std::size_t>(contacts.j[k]);
    contacts.image[k] = image_at(state, data.points[2 * k + 1], particles.position[j]);
    contacts.birth_time[k] = state.time - contacts.birth_time[k];
    contacts.sliding_path[k] *= equivalent_radius(particles.radius[i], particles.radius[j]);
  }
}

run::NeckArrays necks_in(const io::PolyData& data) {
  const std::size_t count = data.points.size() / 2;
  const auto known = [&](std::string_view name) {
    std::vector<double> values = values_of(data.cell_arrays, name, count);
    if (!values.empty() && std::isnan(values.front())) values.clear();
    return values;
  };
  return {known("neck_radius [m]"), known("normal_resistance [N s/m]"), known("sliding_resistance [N s/m]")};
}

// Overlapping pairs that are no contacts: a neck broke there, and the union of the spheres must know.
void find_cracks(State& state) {
  const Contacts& contacts = state.contacts;
  std::size_t k = 0;
  const auto key = [&](std::size_t n) { return std::tuple(contacts.i[n], contacts.j[n], contacts.image[n]); };
  for (const neighbor::Pair& pair : neighbor::find_pairs(state.particles, state.cell, 0.0)) {
    const std::tuple own(pair.i, pair.j, pair.image);
    while (k < contacts.size() && key(k) < own) ++k;
    if (k == contacts.size() || key(k) != own) state.cracks.add(pair.i, pair.j, pair.image, 0.0);
  }
}

Moment with_contacts(State state, const fs::path& path) {
  const io::PolyData data = io::read_vtp(path);
  if (data.cells != io::PolyCells::segments && !data.points.empty())
    throw InputError(path.string() + ": holds particles, not a contact network");
  fill_contacts(data, path.string(), state);
  find_cracks(state);
  return {{}, std::move(state), necks_in(data)};
}

}  // namespace

std::vector<SnapshotFiles> list_snapshots(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw InputError(fmt::format("{}: no such folder; allowed: the folder of a result", folder.string()));
  if (!fs::is_regular_file(folder / "snapshots.pvd", error)) {
    throw InputError(
        fmt::format("{}: holds no snapshots (snapshots.pvd); run the case with output.snapshots = true",
                    folder.string()));
  }
  std::vector<SnapshotFiles> snapshots;
  for (const io::PvdEntry& entry : io::read_pvd(folder / "snapshots.pvd")) {
    if (entry.part == 0) snapshots.push_back({folder / entry.file, {}});
    if (entry.part == 1 && !snapshots.empty()) snapshots.back().contacts = folder / entry.file;
  }
  for (const SnapshotFiles& files : snapshots) {
    if (files.contacts.empty())
      throw InputError(fmt::format("{}: {} has no contacts", (folder / "snapshots.pvd").string(),
                                   files.particles.filename().string()));
  }
  if (snapshots.empty()) throw InputError((folder / "snapshots.pvd").string() + ": lists no snapshots");
  return snapshots;
}

State state_of(const io::Frame& frame) {
  std::vector<std::size_t> order(frame.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t row) { return frame.ids[row]; });
  State state;
  Particles& particles = state.particles;
  for (const std::size_t row : order) particles.add(frame.positions[row], frame.radii[row]);
  particles.id = picked(frame.ids, order);
  particles.velocity = picked(vectors_of(frame.arrays, "velocity [m/s]", frame.size()), order);
  particles.spin = picked(vectors_of(frame.arrays, "spin [1/s]", frame.size()), order);
  const auto rotations = picked(vectors_of(frame.arrays, "rotation [rad]", frame.size()), order);
  std::ranges::transform(rotations, particles.orientation.begin(), orientation_of);
  state.cell = frame.cell;
  state.time = frame.time;
  state.temperature = values_of(frame.file_arrays, "temperature [K]", 1).front();
  state.theta = values_of(frame.file_arrays, "theta [m^5 s/(N s)]", 1).front();
  state.cell_rate = vectors_of(frame.file_arrays, "cell_rate [1/s]", 1).front();
  // Only differences of it count: the logarithm of the ratio of two sizes.
  if (frame.cell.periodic) state.cell_strain = frame.cell.size.array().log();
  return state;
}

void set_contacts(State& state, std::span<const neighbor::Pair> pairs) {
  Contacts& contacts = state.contacts;
  contacts.resize(pairs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    contacts.i[k] = pairs[k].i;
    contacts.j[k] = pairs[k].j;
    contacts.image[k] = pairs[k].image;
  }
  for (auto* unknown : {&contacts.normal_force, &contacts.approach_velocity, &contacts.rolling_path,
                        &contacts.twisting_path, &contacts.sliding_path}) {
    unknown->assign(pairs.size(), no_value);
  }
  contacts.sliding_velocity.assign(pairs.size(), Vec3::Constant(no_value));
}

Moment read_snapshot(const SnapshotFiles& files) {
  Moment moment = with_contacts(state_of(io::read_frame(files.particles)), files.contacts);
  moment.name = files.particles.filename().string();
  return moment;
}

Moment read_particles(const fs::path& path) {
  std::string name = path.filename().string();
  std::error_code error;
  if (name.starts_with("particles_") && name.ends_with(".vtp")) {
    const fs::path contacts = path.parent_path() / ("contacts_" + name.substr(10));
    if (fs::is_regular_file(contacts, error)) return read_snapshot({path, contacts});
  }
  Moment moment{name, state_of(io::read_frame(path)), {}};
  set_contacts(moment.state, neighbor::find_pairs(moment.state.particles, moment.state.cell, 0.0));
  return moment;
}

}  // namespace frit::analyze
