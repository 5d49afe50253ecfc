#include "run/snapshots.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>

#include "io/extended_xyz.hpp"
#include "io/lammps_dump.hpp"
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

SnapshotWriter::SnapshotWriter(const std::filesystem::path& folder,
                               std::vector<config::SnapshotFormat> formats, const std::vector<double>& times)
    : folder_(folder), formats_(std::move(formats)) {
  make_folder(folder_ / "snapshots");
  for (const double time : times) add_entries(time);
  if (!times.empty()) write_collection();
}

std::string SnapshotWriter::name_of(std::string_view what, std::string_view extension) const {
  return fmt::format("snapshots/{}_{:06}.{}", what, entries_.size() / 2, extension);
}

void SnapshotWriter::add_entries(double time) {
  const std::string particles = name_of("particles", "vtp"), contacts = name_of("contacts", "vtp");
  entries_.push_back({time, particles, 0, "particles"});
  entries_.push_back({time, contacts, 1, "contacts"});
}

void SnapshotWriter::write_collection() const {
  if (std::ranges::find(formats_, config::SnapshotFormat::vtp) == formats_.end()) return;
  io::write_pvd(folder_ / "snapshots.pvd", entries_);
}

void SnapshotWriter::write(const observe::Reference& reference, const State& ordered,
                           const NeckArrays& necks) {
  const io::Frame particles = particle_frame(reference, ordered);
  for (const config::SnapshotFormat format : formats_) {
    switch (format) {
      case config::SnapshotFormat::vtp:
        io::write_vtp(folder_ / name_of("particles", "vtp"), particles);
        io::write_vtp(folder_ / name_of("contacts", "vtp"), contact_frame(ordered, necks));
        break;
      case config::SnapshotFormat::extended_xyz:
        io::write_extended_xyz(folder_ / name_of("particles", "xyz"), particles);
        break;
      case config::SnapshotFormat::lammps_dump:
        io::write_lammps_dump(folder_ / name_of("particles", "dump"), particles);
        break;
    }
  }
  add_entries(ordered.time);
  write_collection();
}

}  // namespace frit::run
