#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "config/case_writer.hpp"
#include "config/schema.hpp"
#include "samples.hpp"

namespace frit::config {
namespace {

std::uint64_t bits(double value) { return std::bit_cast<std::uint64_t>(value); }

std::vector<std::uint64_t> bits(const std::optional<Vec3>& value) {
  return value ? std::vector{bits(value->x()), bits(value->y()), bits(value->z())}
               : std::vector<std::uint64_t>{};
}

std::optional<std::uint64_t> bits(const std::optional<double>& value) {
  return value ? std::optional(bits(*value)) : std::nullopt;
}

void expect_same_packing_and_cell(const Case& a, const Case& b) {
  EXPECT_EQ(a.title, b.title);
  EXPECT_EQ(a.packing.file, b.packing.file);
  EXPECT_EQ(a.packing.contacts, b.packing.contacts);
  EXPECT_EQ(a.packing.generate, b.packing.generate);
  EXPECT_EQ(a.packing.count, b.packing.count);
  EXPECT_EQ(bits(a.packing.radius), bits(b.packing.radius));
  EXPECT_EQ(bits(a.packing.radius_spread), bits(b.packing.radius_spread));
  EXPECT_EQ(bits(a.packing.relative_density), bits(b.packing.relative_density));
  EXPECT_EQ(a.packing.seed, b.packing.seed);
  EXPECT_EQ(a.cell.kind, b.cell.kind);
  EXPECT_EQ(bits(a.cell.size), bits(b.cell.size));
  EXPECT_EQ(bits(a.cell.stress), bits(b.cell.stress));
  EXPECT_EQ(bits(a.cell.strain_rate), bits(b.cell.strain_rate));
}

void expect_same_material_and_contact(const Case& a, const Case& b) {
  EXPECT_EQ(a.material.use, b.material.use);
  EXPECT_EQ(bits(a.material.density), bits(b.material.density));
  EXPECT_EQ(bits(a.material.surface_energy), bits(b.material.surface_energy));
  EXPECT_EQ(bits(a.material.dihedral_angle), bits(b.material.dihedral_angle));
  EXPECT_EQ(bits(a.material.atomic_volume), bits(b.material.atomic_volume));
  const auto &diffusion_a = a.material.boundary_diffusion, &diffusion_b = b.material.boundary_diffusion;
  EXPECT_EQ(bits(diffusion_a.prefactor), bits(diffusion_b.prefactor));
  EXPECT_EQ(bits(diffusion_a.activation_energy), bits(diffusion_b.activation_energy));
  EXPECT_EQ(a.contact.attraction, b.contact.attraction);
  EXPECT_EQ(a.contact.pull, b.contact.pull);
  EXPECT_EQ(bits(a.contact.sliding_resistance), bits(b.contact.sliding_resistance));
  EXPECT_EQ(a.contact.neck_bending, b.contact.neck_bending);
  EXPECT_EQ(a.contact.spins, b.contact.spins);
  EXPECT_EQ(a.contact.equilibrium_radius, b.contact.equilibrium_radius);
  EXPECT_EQ(bits(a.contact.birth_neck_ratio), bits(b.contact.birth_neck_ratio));
  EXPECT_EQ(bits(a.contact.initial_neck_ratio), bits(b.contact.initial_neck_ratio));
}

void expect_same_method_and_output(const Case& a, const Case& b) {
  EXPECT_EQ(a.method.name, b.method.name);
  EXPECT_EQ(a.method.inertia, b.method.inertia);
  EXPECT_EQ(a.method.solver, b.method.solver);
  EXPECT_EQ(bits(a.method.time_step), bits(b.method.time_step));
  EXPECT_EQ(bits(a.method.accuracy), bits(b.method.accuracy));
  EXPECT_EQ(bits(a.method.tolerance), bits(b.method.tolerance));
  EXPECT_EQ(bits(a.method.largest_step), bits(b.method.largest_step));
  EXPECT_EQ(bits(a.method.smallest_step), bits(b.method.smallest_step));
  EXPECT_EQ(bits(a.method.density_factor), bits(b.method.density_factor));
  EXPECT_EQ(bits(a.method.cell_inertia), bits(b.method.cell_inertia));
  EXPECT_EQ(bits(a.stop.time), bits(b.stop.time));
  EXPECT_EQ(bits(a.stop.relative_density), bits(b.stop.relative_density));
  EXPECT_EQ(bits(a.output.every_density), bits(b.output.every_density));
  EXPECT_EQ(bits(a.output.every_time), bits(b.output.every_time));
  EXPECT_EQ(a.output.every_steps, b.output.every_steps);
  EXPECT_EQ(a.output.snapshots, b.output.snapshots);
  EXPECT_EQ(a.output.formats, b.output.formats);
  EXPECT_EQ(a.output.checkpoint_every_steps, b.output.checkpoint_every_steps);
}

void expect_same_lists(const Case& a, const Case& b) {
  EXPECT_EQ(bits(a.temperature.start), bits(b.temperature.start));
  ASSERT_EQ(a.temperature.program.size(), b.temperature.program.size());
  for (std::size_t n = 0; n < a.temperature.program.size(); ++n) {
    EXPECT_EQ(bits(a.temperature.program[n].rate), bits(b.temperature.program[n].rate));
    EXPECT_EQ(bits(a.temperature.program[n].to), bits(b.temperature.program[n].to));
    EXPECT_EQ(bits(a.temperature.program[n].hold), bits(b.temperature.program[n].hold));
  }
  ASSERT_EQ(a.particles.size(), b.particles.size());
  for (std::size_t n = 0; n < a.particles.size(); ++n) {
    EXPECT_EQ(a.particles[n].ids, b.particles[n].ids);
    EXPECT_EQ(a.particles[n].fixed, b.particles[n].fixed);
    EXPECT_EQ(bits(std::optional(a.particles[n].force)), bits(std::optional(b.particles[n].force)));
  }
}

void expect_same(const Case& a, const Case& b) {
  expect_same_packing_and_cell(a, b);
  expect_same_material_and_contact(a, b);
  expect_same_method_and_output(a, b);
  expect_same_lists(a, b);
}

// Written, read from another folder, written again: the same case and the same text.
void expect_round_trip(const std::string& text) {
  const Case first = parse_case(text, "/some/folder/case.toml");
  const std::string written = write_case(first, "1.2.3");
  SCOPED_TRACE(written);
  Case second;
  ASSERT_NO_THROW(second = parse_case(written, "/another/case.toml"));
  expect_same(first, second);
  EXPECT_EQ(write_case(second, "1.2.3"), written);
}

TEST(RoundTrip, OfTheLeastCase) { expect_round_trip(least_case); }

TEST(RoundTrip, OfAPackingFromAFileUnderStress) {
  expect_round_trip(
      "title = \"tab\\t quote\\\" back\\\\slash \\u0001 \\u007F µ 粉\"\n"
      "packing = { file = \"a b/p.csv\", contacts = \"n.csv\", seed = 9223372036854775807 }\n"
      "cell = { kind = \"periodic\", size = [\"1 mm\", \"0.1 mm\", 3], stress = [-0.0, 1e-300, \"-1 MPa\"] "
      "}\n"
      "material.use = \"alumina\"\nmaterial.density = 0.1\nstop = { time = 0.1, relative_density = 1 }\n");
}

TEST(RoundTrip, OfEverythingElseThatCanBeSet) {
  expect_round_trip(
      "packing = { generate = \"random-dense\", count = 7, radius = \"0.7 um\", radius_spread = 0.3 }\n"
      "cell = { kind = \"periodic\", strain_rate = [\"-0.1 1/h\", 0, 1] }\nstop.time = \"7 h\"\n"
      "[material]\ndensity = 1\nsurface_energy = 2\ndihedral_angle = \"77 deg\"\natomic_volume = 4e-29\n"
      "boundary_diffusion = { prefactor = 5e-15, activation_energy = 6 }\n"
      "[contact]\nattraction = \"parhami-mcmeeking\"\npull = \"unilateral\"\nneck_bending = true\nspins = "
      "\"blocked\"\n"
      "equilibrium_radius = \"smaller\"\nsliding_resistance = 0.3\nbirth_neck_ratio = "
      "0.1\ninitial_neck_ratio = 0.2\n"
      "[temperature]\nstart = 300\n"
      "program = [{ rate = \"7 K/min\", to = \"900 degC\" }, { hold = \"1 h\" }, { rate = 1, to = 301.7 }]\n"
      "[method]\nname = \"mean-field\"\ninertia = \"dynamic\"\nsolver = \"gauss-seidel\"\naccuracy = 0.003\n"
      "tolerance = 1e-9\nlargest_step = \"7 min\"\nsmallest_step = 1e-17\n"
      "[output]\nevery_time = \"1 min\"\nevery_steps = 3\nsnapshots = false\n"
      "formats = [\"xyz\", \"lammps\"]\n"
      "[[particles]]\nids = [0, 5, 123456789012]\nfixed = true\n"
      "[[particles]]\nids = [1]\nforce = [\"1 uN\", -0.0, \"0.3 nN\"]\n");
}

TEST(RoundTrip, OfALatticeWithAFixedStep) {
  expect_round_trip(least_case + "[method]\ntime_step = \"0.1 s\"\n");
  std::string lattice = least_case;
  lattice.replace(lattice.find("random-dense"), 12, "face-centred-cubic");
  expect_round_trip(lattice);
}

TEST(RoundTrip, OfRandomBitPatterns) {
  std::mt19937_64 random(7);
  for (int n = 0; n < 200; ++n) {
    const double radius = std::bit_cast<double>(random() & 0x7FEFFFFFFFFFFFFFULL);
    const double stress = std::bit_cast<double>(random() & 0xFFEFFFFFFFFFFFFFULL);
    Case whole = parse_case(least_case + "[cell]\nkind = \"periodic\"\n", "case.toml");
    if (radius > 0.0) whole.packing.radius = radius;
    whole.cell.stress = Vec3(stress, -stress, 0.0);
    expect_same(whole, parse_case(write_case(whole, "0"), "case.toml"));
  }
}

TEST(Written, NamesTheVersionAndTheUnits) {
  const auto written = write_case(parse_case(least_case, "case.toml"), "0.1.0 (abc)");
  EXPECT_TRUE(written.starts_with("# Written by frit 0.1.0 (abc)"));
  for (const auto* line :
       {"radius = 5e-06  # [m]", "start = 1323.15  # [K]", "use = \"copper\"", "time_step = \"auto\"  # [s]",
        "boundary_diffusion.prefactor = 5.12e-15  # [m^3/s]"})
    EXPECT_NE(written.find(line), written.npos) << line << "\n" << written;
}

TEST(Written, HoldsEveryKeyThatAppliesAndHasAValue) {
  const auto written = write_case(parse_case(least_case, "case.toml"), "0");
  for (const Key& key : schema()) {
    const bool own_line =
        !key.path.starts_with("temperature.program.") && !key.path.starts_with("particles.");
    if (!own_line || key.fallback.empty() || key.applies == Applies::periodic ||
        key.applies == Applies::verlet)
      continue;
    const auto name = key.path.substr(key.path.find('.') + 1);
    EXPECT_NE(written.find("\n" + std::string(name) + " = "), written.npos) << key.path;
  }
}

}  // namespace
}  // namespace frit::config
