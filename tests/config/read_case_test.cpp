#include <gtest/gtest.h>

#include <fstream>

#include "config/case_reader.hpp"
#include "config/materials.hpp"
#include "core/constants.hpp"
#include "core/error.hpp"
#include "samples.hpp"

namespace frit::config {
namespace {

Case read(const std::string& text) { return parse_case(text, "case.toml"); }

TEST(Defaults, OfPackingAndCellAreThoseOfTheInterface) {
  const Case whole = read(least_case);
  EXPECT_EQ(whole.title, "");
  EXPECT_EQ(whole.packing.generate, Generator::random_dense);
  EXPECT_FALSE(whole.packing.file || whole.packing.contacts);
  EXPECT_EQ(whole.packing.count, 4000);
  EXPECT_EQ(whole.packing.radius, 5e-6);
  EXPECT_EQ(whole.packing.radius_spread, 0.0);
  EXPECT_EQ(whole.packing.relative_density, 0.64);
  EXPECT_EQ(whole.packing.seed, 1);
  EXPECT_EQ(whole.cell.kind, CellKind::free);
  EXPECT_FALSE(whole.cell.size || whole.cell.stress || whole.cell.strain_rate);
  EXPECT_TRUE(whole.particles.empty());
}

TEST(Defaults, OfContactsAndTemperatureAreThoseOfTheInterface) {
  const Case whole = read(least_case);
  EXPECT_EQ(whole.contact.attraction, Attraction::bouvard_mcmeeking);
  EXPECT_EQ(whole.contact.pull, Pull::bilateral);
  EXPECT_EQ(whole.contact.sliding_resistance, 0.01);
  EXPECT_FALSE(whole.contact.neck_bending);
  EXPECT_EQ(whole.contact.spins, Spins::free);
  EXPECT_EQ(whole.contact.equilibrium_radius, EquilibriumRadius::equivalent);
  EXPECT_EQ(whole.contact.birth_neck_ratio, 0.03);
  EXPECT_EQ(whole.contact.initial_neck_ratio, 0.0);
  EXPECT_EQ(whole.temperature.start, 1323.15);
  EXPECT_TRUE(whole.temperature.program.empty());
}

TEST(Defaults, OfMethodStopAndOutputAreThoseOfTheInterface) {
  const Case whole = read(least_case);
  EXPECT_EQ(whole.method.name, MethodName::contact_dynamics);
  EXPECT_EQ(whole.method.inertia, Inertia::overdamped);
  EXPECT_EQ(whole.method.solver, Solver::automatic);
  EXPECT_FALSE(whole.method.time_step || whole.method.tolerance);
  EXPECT_FALSE(whole.method.largest_step || whole.method.smallest_step);
  EXPECT_EQ(whole.method.accuracy, 0.01);
  EXPECT_EQ(whole.method.density_factor, 1.0);
  EXPECT_EQ(whole.stop.time, 7200.0);
  EXPECT_FALSE(whole.stop.relative_density);
  EXPECT_EQ(whole.output.every_density, 0.01);
  EXPECT_FALSE(whole.output.every_time || whole.output.every_steps);
  EXPECT_TRUE(whole.output.snapshots);
  EXPECT_EQ(whole.output.formats, std::vector{SnapshotFormat::vtp});
  EXPECT_EQ(whole.output.checkpoint_every_steps, 0);
}

TEST(Materials, CopperIsThatOfThePhysics) {
  const Material copper = read(least_case).material;
  EXPECT_EQ(copper.use, "copper");
  EXPECT_EQ(copper.density, 8960.0);
  EXPECT_EQ(copper.surface_energy, 1.72);
  EXPECT_NEAR(copper.dihedral_angle * 180.0 / pi, 146.0, 1e-12);
  EXPECT_EQ(copper.atomic_volume, 1.18e-29);
  EXPECT_EQ(copper.boundary_diffusion.prefactor, 5.12e-15);
  EXPECT_EQ(copper.boundary_diffusion.activation_energy, 105e3);
}

// physics.md, section 8: Delta_b = 2.37e-28 m^5/(N s) for copper at 1050 degC.
TEST(Materials, CopperHasTheKnownDiffusionParameterAt1050Celsius) {
  const Case whole = read(least_case);
  const auto& diffusion = whole.material.boundary_diffusion;
  const double T = whole.temperature.start;
  const double delta_b = whole.material.atomic_volume * diffusion.prefactor *
                         std::exp(-diffusion.activation_energy / (gas_constant * T)) /
                         (boltzmann_constant * T);
  EXPECT_NEAR(delta_b, 2.37e-28, 0.005e-28);
}

TEST(Materials, KeysBesideUseOverrideOnlyThemselves) {
  const Case whole = read(least_case +
                          "[material.boundary_diffusion]\nprefactor = \"5.0e-15 m^3/s\"\n"
                          "activation_energy = \"104 kJ/mol\"\n");
  EXPECT_EQ(whole.material.boundary_diffusion.prefactor, 5.0e-15);
  EXPECT_EQ(whole.material.boundary_diffusion.activation_energy, 104e3);
  EXPECT_EQ(whole.material.density, 8960.0);
}

TEST(Materials, MayBeGivenWholeWithoutABuiltInOne) {
  const Case whole = read(
      "packing = { generate = \"simple-cubic\" }\nstop.time = 1\n[material]\ndensity = 1\nsurface_energy = "
      "2\n"
      "dihedral_angle = 3\natomic_volume = 4\nboundary_diffusion = { prefactor = 5, activation_energy = 6 "
      "}\n");
  EXPECT_EQ(whole.material.use, "");
  EXPECT_EQ(whole.material.surface_energy, 2.0);
  EXPECT_EQ(whole.material.boundary_diffusion.activation_energy, 6.0);
}

TEST(Materials, TextNamesEveryMaterialWithItsSource) {
  const auto text = materials_text();
  for (const auto& built_in : materials()) {
    EXPECT_NE(text.find(built_in.material.use), text.npos);
    EXPECT_NE(text.find(built_in.source), text.npos);
  }
  for (const auto* part : {"146 deg", "5.12e-15", "232 kJ/mol", "3980", "Swinkels"})
    EXPECT_NE(text.find(part), text.npos) << part;
}

TEST(Paths, AreRelativeToTheFolderOfTheCase) {
  const std::string text =
      "packing.file = \"in/packing.csv\"\npacking.contacts = \"../necks.csv\"\n"
      "material.use = \"copper\"\nstop.time = 1\n";
  const Case whole = parse_case(text, "/data/cases/case.toml");
  EXPECT_EQ(whole.packing.file, "/data/cases/in/packing.csv");
  EXPECT_EQ(whole.packing.contacts, "/data/necks.csv");
  EXPECT_TRUE(parse_case(text, "case.toml").packing.file->is_absolute());
}

TEST(PeriodicCell, IsFreeOfStressUnlessToldOtherwise) {
  const std::string periodic = least_case + "[cell]\nkind = \"periodic\"\n";
  EXPECT_EQ(read(periodic).cell.stress, Vec3::Zero());
  EXPECT_EQ(read(periodic + "stress = \"-1 MPa\"\n").cell.stress, Vec3(-1e6, -1e6, -1e6));
  EXPECT_EQ(read(periodic + "stress = [0, \"2 kPa\", -3.0]\n").cell.stress, Vec3(0, 2e3, -3));
}

TEST(PeriodicCell, AtAStrainRateHasNoStress) {
  const Case whole = read(least_case + "[cell]\nkind = \"periodic\"\nstrain_rate = [0, 0, \"-1e-4 1/s\"]\n");
  EXPECT_EQ(whole.cell.strain_rate, Vec3(0, 0, -1e-4));
  EXPECT_FALSE(whole.cell.stress);
}

TEST(FreeCell, TakesZeroStressAsTheNothingItIs) {
  EXPECT_FALSE(read(least_case + "[cell]\nstress = \"0 MPa\"\n").cell.stress);
}

TEST(TemperatureProgramme, RatesTakeTheSignOfTheirRamp) {
  const auto program =
      read(least_case +
           "[temperature]\nstart = \"20 degC\"\nprogram = [{ rate = \"10 K/min\", to = \"1050 degC\" "
           "}, { hold = \"1 h\" }, { rate = \"5 K/min\", to = 300 }, { rate = -1, to = 290 }]\n")
          .temperature.program;
  ASSERT_EQ(program.size(), 4U);
  EXPECT_EQ(program[0].rate, 10.0 / 60.0);
  EXPECT_EQ(program[0].to, 1323.15);
  EXPECT_FALSE(program[0].hold);
  EXPECT_EQ(program[1].hold, 3600.0);
  EXPECT_FALSE(program[1].rate || program[1].to);
  EXPECT_EQ(program[2].rate, -5.0 / 60.0);
  EXPECT_EQ(program[3].rate, -1.0);
}

TEST(Outputs, DefaultToDensityOnlyWhileNoOtherIntervalIsGiven) {
  const Case by_time = read(least_case + "[output]\nevery_time = \"1 min\"\n");
  EXPECT_EQ(by_time.output.every_time, 60.0);
  EXPECT_FALSE(by_time.output.every_density);
  const Case both = read(least_case + "[output]\nevery_steps = 5\nevery_density = 0.02\n");
  EXPECT_EQ(both.output.every_steps, 5);
  EXPECT_EQ(both.output.every_density, 0.02);
}

TEST(Outputs, FormatsAreAListOfNames) {
  using enum SnapshotFormat;
  const auto formats_of = [](const std::string& list) {
    return read(least_case + "[output]\nformats = " + list + "\n").output.formats;
  };
  EXPECT_EQ(formats_of("[\"lammps\"]"), std::vector{lammps_dump});
  EXPECT_EQ(formats_of("[\"xyz\", \"vtp\"]"), (std::vector{extended_xyz, vtp}));
  for (const std::string wrong : {"[]", "\"vtp\"", "[\"vtp\", \"vtp\"]", "[\"vtk\"]", "[1]"})
    EXPECT_THROW(formats_of(wrong), InputError) << wrong;
}

TEST(ParticleGroups, HoldRowsAndForces) {
  const Case whole = read(least_case +
                          "[[particles]]\nids = [0, 3]\nfixed = true\n"
                          "[[particles]]\nids = [1]\nforce = [\"1 uN\", \"0 N\", 0]\n");
  ASSERT_EQ(whole.particles.size(), 2U);
  EXPECT_EQ(whole.particles[0].ids, (std::vector<std::int64_t>{0, 3}));
  EXPECT_TRUE(whole.particles[0].fixed);
  EXPECT_EQ(whole.particles[0].force, Vec3::Zero());
  EXPECT_FALSE(whole.particles[1].fixed);
  EXPECT_EQ(whole.particles[1].force, Vec3(1e-6, 0, 0));
}

TEST(Automatic, IsAWordAmongTheTimes) {
  const Case whole =
      read(least_case + "[method]\ntime_step = \"auto\"\ntolerance = 1e-9\nlargest_step = \"10 s\"\n");
  EXPECT_FALSE(whole.method.time_step);
  EXPECT_EQ(whole.method.tolerance, 1e-9);
  EXPECT_EQ(whole.method.largest_step, 10.0);
}

TEST(LoadCase, ReadsAFileAndTakesItsFolder) {
  const auto path = std::filesystem::path(testing::TempDir()) / "frit_load_case_test.toml";
  std::ofstream(path) << "packing.file = \"p.csv\"\nmaterial.use = \"nickel\"\nstop.time = 1\n";
  const Case whole = load_case(path, {"stop.time=2"});
  std::filesystem::remove(path);
  EXPECT_EQ(whole.packing.file, std::filesystem::absolute(path).parent_path() / "p.csv");
  EXPECT_EQ(whole.stop.time, 2.0);
}

TEST(LoadCase, NamesAMissingFileAndAFolder) {
  for (const auto& [path, part] : {std::pair<std::string, std::string>{"no/such/case.toml", "no such file"},
                                   {testing::TempDir(), "this is a folder"}}) {
    try {
      load_case(path);
      ADD_FAILURE() << path;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(part), std::string::npos) << error.what();
      EXPECT_NE(std::string(error.what()).find(path), std::string::npos) << error.what();
    }
  }
}

}  // namespace
}  // namespace frit::config
