#include "run/packing.hpp"

#include <fmt/core.h>

#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <vector>

#include "core/constants.hpp"
#include "core/error.hpp"
#include "generate/lattice.hpp"
#include "generate/random_dense.hpp"
#include "io/contacts_csv.hpp"
#include "io/frame_files.hpp"

namespace frit::run {
namespace {

using config::Generator;

generate::Packing make_random(const config::Case& whole, generate::Boundary boundary,
                              const std::function<bool()>& abandon) {
  generate::RandomDenseOptions options;
  options.count = whole.packing.count;
  options.mean_radius = whole.packing.radius;
  options.relative_spread = whole.packing.radius_spread;
  options.relative_density = whole.packing.relative_density;
  options.seed = static_cast<std::uint64_t>(whole.packing.seed);
  options.boundary = boundary;
  options.abandon = abandon;
  return generate::make_random_dense(options);
}

generate::Packing generated(const config::Case& whole, const std::function<bool()>& abandon) {
  const auto boundary =
      whole.cell.kind == config::CellKind::periodic ? generate::Boundary::periodic : generate::Boundary::free;
  const auto lattice = [&](generate::LatticeKind kind) {
    return generate::make_lattice(kind, whole.packing.radius, whole.packing.count, boundary);
  };
  switch (whole.packing.generate.value_or(Generator::random_dense)) {
    case Generator::random_dense:
      return make_random(whole, boundary, abandon);
    case Generator::simple_cubic:
      return lattice(generate::LatticeKind::simple_cubic);
    case Generator::body_centred_cubic:
      return lattice(generate::LatticeKind::body_centred_cubic);
    case Generator::face_centred_cubic:
      return lattice(generate::LatticeKind::face_centred_cubic);
    case Generator::random_sequential:
    case Generator::gas_compacted:
    case Generator::deposit:
      break;
  }
  throw InputError("packing.generate: not available yet; allowed: random-dense and the cubic lattices");
}

// A path that a key names.
void check_file(const std::string& key, const std::filesystem::path& path) {
  std::error_code error;
  const bool is_folder = std::filesystem::is_directory(path, error);
  if (!is_folder && std::filesystem::exists(path, error)) return;
  throw InputError(fmt::format("{}: {} {}; allowed: a file, its path relative to the case file's folder", key,
                               path.string(), is_folder ? "is a folder" : "is not there"));
}

generate::Packing read(const config::Case& whole) {
  check_file("packing.file", *whole.packing.file);
  const io::Frame frame = io::read_frame(*whole.packing.file);
  if (frame.size() == 0) {
    throw InputError(fmt::format("{}: no particles; at least one is needed", whole.packing.file->string()));
  }
  generate::Packing packing;
  for (std::size_t n = 0; n < frame.size(); ++n) packing.particles.add(frame.positions[n], frame.radii[n]);
  if (whole.cell.kind == config::CellKind::periodic)
    packing.cell = {true, whole.cell.size.value_or(Vec3::Zero())};
  return packing;
}

void wrap_into_cell(generate::Packing& packing) {
  const Vec3& size = packing.cell.size;
  for (Vec3& x : packing.particles.position) {
    for (int axis = 0; axis < 3; ++axis) {
      x[axis] -= std::floor(x[axis] / size[axis]) * size[axis];
      if (x[axis] >= size[axis]) x[axis] = 0.0;  // a coordinate just below zero rounds up
    }
  }
}

void apply_groups(const config::Case& whole, Particles& particles) {
  std::vector<std::string> faults;
  for (std::size_t n = 0; n < whole.particles.size(); ++n) {
    const config::ParticleGroup& group = whole.particles[n];
    for (const std::int64_t id : group.ids) {
      if (id < 0 || static_cast<std::size_t>(id) >= particles.size()) {
        faults.push_back(fmt::format("particles[{}].ids: there is no particle {}; allowed: 0 to {}", n, id,
                                     particles.size() - 1));
        continue;
      }
      particles.fixed[static_cast<std::size_t>(id)] = group.fixed ? 1 : 0;
      particles.force[static_cast<std::size_t>(id)] = group.force;
    }
  }
  if (!faults.empty()) throw InputError(faults);
}

}  // namespace

generate::Packing make_packing(const config::Case& whole, const std::function<bool()>& abandon) {
  generate::Packing packing = whole.packing.file ? read(whole) : generated(whole, abandon);
  Particles& particles = packing.particles;
  for (std::size_t n = 0; n < particles.size(); ++n) {
    const double radius = particles.radius[n];
    particles.mass[n] = whole.material.density * 4.0 / 3.0 * pi * radius * radius * radius;
  }
  if (packing.cell.periodic) wrap_into_cell(packing);
  apply_groups(whole, particles);
  return packing;
}

std::optional<contact::GivenNecks> read_given_necks(const config::Case& whole, std::size_t particle_count) {
  if (!whole.packing.contacts) return std::nullopt;
  check_file("packing.contacts", *whole.packing.contacts);
  const io::ContactTable table = io::read_contacts_csv(*whole.packing.contacts, particle_count);
  contact::GivenNecks given;
  given.neck_radius = table.neck_radius;
  for (std::size_t k = 0; k < table.size(); ++k) given.pairs.push_back({table.i[k], table.j[k]});
  return given;
}

}  // namespace frit::run
