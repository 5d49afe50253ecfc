#include "run/snapshots.hpp"

#include <fmt/core.h>

#include <cstdint>
#include <string>
#include <utility>

#include "observe/fields.hpp"
#include "run/folders.hpp"

namespace frit::run {
namespace {

io::NamedArray vectors(std::string name, const std::vector<Vec3>& values) {
  std::vector<double> numbers;
  numbers.reserve(3 * values.size());
  for (const Vec3& value : values) numbers.insert(numbers.end(), value.begin(), value.end());
  return {std::move(name), 3, std::move(numbers)};
}

void append_fields(std::vector<observe::Field> fields, std::vector<io::NamedArray>& arrays) {
  for (observe::Field& field : fields) {
    arrays.push_back({std::move(field.name), field.components, std::move(field.values)});
  }
}

io::NamedArray ids_of(std::string name, const std::vector<std::int32_t>& rows, const Particles& particles) {
  std::vector<std::int64_t> ids;
  ids.reserve(rows.size());
  for (const std::int32_t row : rows) ids.push_back(particles.id[static_cast<std::size_t>(row)]);
  return {std::move(name), 1, std::move(ids)};
}

}  // namespace

io::Frame particle_frame(const observe::Reference& reference, const State& ordered) {
  const Particles& particles = ordered.particles;
  io::Frame frame;
  frame.time = ordered.time;
  frame.cell = ordered.cell;
  frame.ids = particles.id;
  frame.positions = particles.position;
  frame.radii = particles.radius;
  frame.arrays.push_back(vectors("velocity [m/s]", particles.velocity));
  frame.arrays.push_back(vectors("spin [1/s]", particles.spin));
  append_fields(observe::particle_fields(reference, ordered), frame.arrays);
  frame.file_arrays.push_back({"temperature [K]", 1, std::vector{ordered.temperature}});
  frame.file_arrays.push_back({"theta [m^5 s/(N s)]", 1, std::vector{ordered.theta}});
  frame.file_arrays.push_back(vectors("cell_rate [1/s]", {ordered.cell_rate}));
  return frame;
}

io::ContactFrame contact_frame(const State& ordered, const NeckArrays& necks) {
  const Contacts& contacts = ordered.contacts;
  io::ContactFrame frame;
  frame.time = ordered.time;
  frame.cell = ordered.cell;
  frame.segments = io::contact_segments(ordered.particles.position, ordered.cell, contacts);
  frame.arrays.push_back(ids_of("i", contacts.i, ordered.particles));
  frame.arrays.push_back(ids_of("j", contacts.j, ordered.particles));
  append_fields(observe::contact_fields(ordered, necks.view()), frame.arrays);
  return frame;
}

SnapshotWriter::SnapshotWriter(const std::filesystem::path& folder) : folder_(folder) {
  make_folder(folder_ / "snapshots");
}

SnapshotWriter::SnapshotWriter(const std::filesystem::path& folder, const std::vector<double>& times)
    : SnapshotWriter(folder) {
  for (const double time : times) add_entries(time);
  io::write_pvd(folder_ / "snapshots.pvd", entries_);
}

void SnapshotWriter::add_entries(double time) {
  const std::size_t number = entries_.size() / 2;
  entries_.push_back({time, fmt::format("snapshots/particles_{:06}.vtp", number), 0, "particles"});
  entries_.push_back({time, fmt::format("snapshots/contacts_{:06}.vtp", number), 1, "contacts"});
}

void SnapshotWriter::write(const observe::Reference& reference, const State& ordered,
                           const NeckArrays& necks) {
  add_entries(ordered.time);
  io::write_vtp(folder_ / entries_.end()[-2].file, particle_frame(reference, ordered));
  io::write_vtp(folder_ / entries_.end()[-1].file, contact_frame(ordered, necks));
  io::write_pvd(folder_ / "snapshots.pvd", entries_);
}

}  // namespace frit::run
