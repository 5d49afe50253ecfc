#include "run/setup.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "run/packing.hpp"
#include "run/samples.hpp"

namespace frit::run {
namespace {

using samples::faults_of;
using samples::mentions;
using samples::pair_case;
using samples::periodic_case;
using samples::radius;
using samples::read_case;

config::Case file_case(const io::TemporaryFolder& folder, std::string_view packing,
                       const std::vector<std::string>& overrides = {}) {
  const config::Case whole = pair_case(folder, overrides);
  folder.write("packing.csv", packing);
  return whole;
}

TEST(Setup, MassesAreTheRealDensityTimesTheVolume) {
  const io::TemporaryFolder folder;
  const auto setup = make_setup(pair_case(folder));
  for (const double mass : setup.state.particles.mass)
    EXPECT_NEAR(mass, 8960.0 * 4.0 / 3.0 * pi * std::pow(radius, 3), 1e-24);
}

TEST(Setup, TheTimeScaleIsThatOfTheHottestTemperature) {
  const io::TemporaryFolder folder;
  const auto setup = make_setup(
      pair_case(folder, {"temperature.start=300",
                         "temperature.program=[{rate = 1, to = \"1050 degC\"}, {rate = 1, to = 500}]"}));
  EXPECT_NEAR(setup.time_scale / 1.534e6, 1.0, 1e-3);
  EXPECT_NEAR(setup.limits.smallest / (1e-18 * setup.time_scale), 1.0, 1e-12);
  EXPECT_TRUE(std::isinf(setup.limits.largest));
}

TEST(Setup, PeriodicPositionsAreInsideTheCell) {
  const io::TemporaryFolder folder;
  folder.write("out.csv", "x,y,z,radius\n-1e-20,3.1e-5,-1e-6,5e-6\n9e-6,1e-6,2e-5,5e-6\n");
  const auto whole =
      read_case(folder,
                "[packing]\nfile = \"out.csv\"\n[cell]\nkind = \"periodic\"\nsize = [3e-5, 3e-5, 3e-5]\n"
                "[material]\nuse = \"copper\"\n[stop]\ntime = 1\n");
  const generate::Packing packing = make_packing(whole);
  for (const Vec3& x : packing.particles.position) {
    EXPECT_GE(x.minCoeff(), 0.0);
    EXPECT_LT(x.maxCoeff(), 3e-5);
  }
  EXPECT_NEAR(packing.particles.position[0].z(), 2.9e-5, 1e-18);
}

TEST(Setup, AFurnaceThatPassesTheMeltingTemperatureIsWarnedOf) {
  const io::TemporaryFolder folder;
  const auto warnings = [&](std::vector<std::string> overrides) {
    overrides.push_back("output.every_time=10");
    return make_setup(pair_case(folder, overrides)).warnings;
  };
  const std::string start = "temperature.start=1000",
                    program =
                        "temperature.program=[{rate = 1, to = 1300}, {hold = 100}, {rate = 2, to = 1400}]";
  const auto told = warnings({start, program, "stop.time=1000"});
  ASSERT_EQ(told.size(), 1U);
  EXPECT_NE(told[0].find("passes 1357.77 K"), std::string::npos) << told[0];
  EXPECT_NE(told[0].find("at 428.885 s on its way to 1400 K"), std::string::npos)
      << told[0];  // 300 + 100 + 57.77/2
  EXPECT_TRUE(warnings({start, program, "stop.time=428"}).empty()) << "the run ends before";
  EXPECT_TRUE(warnings({start, program, "stop.time=1000", "material.melting_temperature=1500"}).empty());
  const auto at_once = warnings({"temperature.start=1100 degC"});
  ASSERT_EQ(at_once.size(), 1U);
  EXPECT_NE(at_once[0].find("at 0 s"), std::string::npos) << at_once[0];
}

TEST(Setup, GroupsHoldAndLoadTheirParticles) {
  const io::TemporaryFolder folder;
  const auto setup = make_setup(
      pair_case(folder, {"particles=[{ids = [1], fixed = true}, {ids = [0], force = [\"1 uN\", 0, 0]}]"}));
  const Particles& particles = setup.state.particles;
  for (std::size_t n = 0; n < 2; ++n) {
    EXPECT_EQ(particles.fixed[n], particles.id[n] == 1 ? 1 : 0);
    EXPECT_DOUBLE_EQ(particles.force[n].x(), particles.id[n] == 0 ? 1e-6 : 0.0);
  }
}

TEST(Setup, GivenContactsAreThoseOfTheRowsWhateverTheInternalOrder) {
  const io::TemporaryFolder folder;
  // Along -x, so that the curve turns the rows around.
  folder.write("necks.csv", "i,j,neck_radius [um]\n0,1,1\n1,2,2\n");
  const auto setup = make_setup(
      file_case(folder, "x,y,z,radius\n2e-5,0,0,5e-6\n1e-5,0,0,5e-6\n0,0,0,5e-6\n9.99e-6,9.9e-6,0,5e-6\n",
                {"packing.contacts=necks.csv"}));
  const Contacts& contacts = setup.state.contacts;
  ASSERT_EQ(contacts.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    const auto i = setup.state.particles.id[static_cast<std::size_t>(contacts.i[k])];
    const auto j = setup.state.particles.id[static_cast<std::size_t>(contacts.j[k])];
    EXPECT_NEAR(std::sqrt(contacts.neck_radius_squared[k]), std::min(i, j) == 0 ? 1e-6 : 2e-6, 1e-18);
  }
  EXPECT_EQ(setup.state.cracks.size(), 1u) << "an overlap without a given neck is a face without one";
}

TEST(SetupFaults, IdsBeyondThePackingAreNamedAllTogether) {
  const io::TemporaryFolder folder;
  const auto faults = faults_of(pair_case(folder, {"particles=[{ids = [0, 7]}, {ids = [9]}]"}));
  EXPECT_EQ(faults.size(), 2u);
  EXPECT_TRUE(mentions(faults, {"particles[0].ids", "7", "0 to 1"}));
  EXPECT_TRUE(mentions(faults, {"particles[1].ids", "9", "0 to 1"}));
}

TEST(SetupFaults, APackingWithoutAnyContactIsRefused) {
  const io::TemporaryFolder folder;
  const auto apart = "x,y,z,radius\n0,0,0,5e-6\n2e-5,0,0,5e-6\n";
  EXPECT_TRUE(mentions(faults_of(file_case(folder, apart)), {"packing.csv", "no two particles touch"}));
  EXPECT_TRUE(
      mentions(faults_of(file_case(folder, "x,y,z,radius\n0,0,0,5e-6\n")), {"no two particles touch"}));
}

TEST(SetupFaults, ALoadThatPushesParticlesTogetherIsEnough) {
  const io::TemporaryFolder folder;
  const auto apart = "x,y,z,radius\n0,0,0,5e-6\n1.01e-5,0,0,5e-6\n";
  EXPECT_NO_THROW(
      make_setup(file_case(folder, apart, {"particles=[{ids = [0], force = [\"1 nN\", 0, 0]}]"})));
}

TEST(SetupFaults, AnEmptyPackingIsRefused) {
  const io::TemporaryFolder folder;
  EXPECT_TRUE(mentions(faults_of(file_case(folder, "x,y,z,radius\n")), {"packing.csv", "no particles"}));
}

TEST(SetupFaults, ASphereInsideAnotherIsRefused) {
  const io::TemporaryFolder folder;
  EXPECT_TRUE(mentions(faults_of(file_case(folder, "x,y,z,radius\n0,0,0,5e-6\n3e-6,0,0,5e-6\n")),
                       {"packing.csv", "particles 0 and 1", "inside"}));
}

TEST(SetupFaults, ADensityStopNeedsACoreOfFiftyParticles) {
  const io::TemporaryFolder folder;
  EXPECT_TRUE(mentions(faults_of(pair_case(folder, {"stop.relative_density=0.9"})),
                       {"stop.relative_density", "core", "50", "stop.time"}));
}

TEST(SetupFaults, ADensityStopThatIsReachedAlreadyIsRefused) {
  const io::TemporaryFolder folder;
  EXPECT_TRUE(mentions(faults_of(periodic_case(folder, "simple-cubic", 8, {"stop.relative_density=0.5"})),
                       {"stop.relative_density", "0.523599"}));
}

TEST(SetupFaults, GivenNecksMustNotBridgeAWideGap) {
  const io::TemporaryFolder folder;
  folder.write("necks.csv", "i,j\n0,1\n");
  const auto at = [&](double x) {
    return faults_of(file_case(folder, fmt::format("x,y,z,radius\n0,0,0,5e-6\n{},0,0,5e-6\n", x),
                               {"packing.contacts=necks.csv", "stop.time=1"}));
  };
  EXPECT_TRUE(mentions(at(1.06e-5), {"necks.csv", "particles 0 and 1", "6e-07", "5e-07"}));
  EXPECT_TRUE(at(1.04e-5).empty());
}

TEST(SetupFaults, ACellMustHoldItsParticles) {
  const io::TemporaryFolder folder;
  const auto sized = [&](const std::string& size) {
    return faults_of(file_case(folder, samples::touching_pair, {"cell.kind=periodic", "cell.size=" + size}));
  };
  EXPECT_TRUE(mentions(sized("[9e-6, 1e-3, 1e-3]"), {"cell.size", "9e-06", "1e-05"}));
  folder.write("dense.csv", "");
  const auto crowded =
      "x,y,z,radius\n0,0,0,5e-6\n5.1e-6,5.1e-6,0,5e-6\n5.1e-6,0,5.1e-6,5e-6\n0,5.1e-6,5.1e-6,5e-6\n";
  EXPECT_TRUE(mentions(
      faults_of(file_case(folder, crowded, {"cell.kind=periodic", "cell.size=[1.02e-5, 1.02e-5, 1.02e-5]"})),
      {"cell.size", "fill"}));
}

TEST(SetupFaults, FaultsOfContactsAndStopComeTogether) {
  const io::TemporaryFolder folder;
  const auto faults = faults_of(
      file_case(folder, "x,y,z,radius\n0,0,0,5e-6\n2e-5,0,0,5e-6\n", {"stop.relative_density=0.9"}));
  EXPECT_TRUE(mentions(faults, {"no two particles touch"}));
  EXPECT_TRUE(mentions(faults, {"stop.relative_density"}));
}

TEST(SetupWarnings, ASmallerSphereThatEndsGrowthIsTold) {
  const io::TemporaryFolder folder;
  const auto unequal = "x,y,z,radius\n0,0,0,2.5e-6\n7.5e-6,0,0,5e-6\n";
  EXPECT_TRUE(
      mentions(make_setup(file_case(folder, unequal)).warnings, {"contact.equilibrium_radius", "1 of 1"}));
  EXPECT_FALSE(
      mentions(make_setup(file_case(folder, unequal, {"contact.equilibrium_radius=smaller"})).warnings,
               {"contact.equilibrium_radius"}));
  EXPECT_FALSE(mentions(make_setup(pair_case(folder)).warnings, {"contact.equilibrium_radius"}));
}

TEST(SetupWarnings, DensityOutputsOfABodyWithoutDensityAreTold) {
  const io::TemporaryFolder folder;
  EXPECT_TRUE(mentions(make_setup(pair_case(folder)).warnings, {"output.every_density"}));
  EXPECT_TRUE(make_setup(pair_case(folder, {"output.every_time=1"})).warnings.empty());
}

}  // namespace
}  // namespace frit::run
