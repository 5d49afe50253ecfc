#include <gtest/gtest.h>

#include "samples.hpp"

namespace frit::config {
namespace {

struct WrongCase {
  std::string text;     // after least_case, which has 6 lines
  std::string message;  // part of the only fault
};

void expect_one_fault(const WrongCase& sample, const std::string& start = least_case) {
  const auto faults = faults_of(start + sample.text);
  EXPECT_EQ(faults.size(), 1U) << sample.text << "\n" << all_of(faults);
  EXPECT_NE(all_of(faults).find(sample.message), std::string::npos) << sample.text << "\n" << all_of(faults);
}

TEST(WrongCase, ValuesOfTheWrongTypeUnitOrRange) {
  const WrongCase samples[] = {
      {"[contact]\nsliding_resistance = 0.5\n",
       "case.toml:8: contact.sliding_resistance: 0.5 is out of range; allowed: at least 0, below 0.5"},
      {"[contact]\nsliding_resistance = -0.1\n", "-0.1 is out of range"},
      {"[contact]\nsliding_resistance = \"0.1\"\n", "\"0.1\" does not fit; allowed is a number"},
      {"[contact]\nsliding_resistance = nan\n", "nan is not a finite number"},
      {"[contact]\nsliding_resistance = true\n", "true does not fit"},
      {"[contact]\nneck_bending = 1\n",
       "case.toml:8: contact.neck_bending: 1 does not fit; allowed is true or false"},
      {"[contact]\nneck_bending = \"yes\"\n", "allowed is true or false"},
      {"[contact]\nspins = \"fre\"\n",
       "\"fre\" is unknown; did you mean free?; allowed: \"free\", \"blocked\""},
      {"[contact]\npull = 3\n", "contact.pull: 3 does not fit; allowed is one of some names"},
      {"[contact]\nattraction = \"hertz\"\n", "allowed: \"bouvard-mcmeeking\", \"parhami-mcmeeking\""},
      {"[contact]\nbirth_neck_ratio = 0\n", "allowed: above 0, below 1"},
      {"[contact]\nbirth_neck_ratio = 0.97\n",
       "beyond equilibrium; allowed: below sin(dihedral_angle/2) = 0.956305"},
      {"[contact]\ninitial_neck_ratio = 0.97\n", "contact.initial_neck_ratio: 0.97 is beyond equilibrium"},
      {"[temperature]\nstart = \"-300 degC\"\n",
       "temperature.start: \"-300 degC\" is out of range; allowed: above 0 K"},
      {"[temperature]\nstart = \"1050 C\"\n", "write degC or K"},
      {"[temperature]\nstart = \"5 um\"\n", "this is a length; a temperature is wanted"},
      {"[temperature]\nstart = 2020-01-01\n", "a date or time does not fit"},
      {"[method]\ntime_step = 0\n", "method.time_step: 0 is out of range; allowed: above 0 s"},
      {"[method]\ntime_step = \"fast\"\n", "no number in front; a time is wanted"},
      {"[method]\naccuracy = \"auto\"\n", "\"auto\" does not fit; allowed is a number"},
      {"[method]\naccuracy = 1\n", "allowed: above 0, below 1"},
      {"[method]\ntolerance = 0\n", "method.tolerance: 0 is out of range"},
      {"[method]\nsolver = \"gauss_seidel\"\n", "did you mean gauss-seidel?"},
      {"[cell]\nkind = \"cubic\"\n", "cell.kind: \"cubic\" is unknown"},
      {"[output]\nevery_steps = 0\n", "allowed: at least 1"},
      {"[output]\nevery_steps = 2.0\n", "allowed is a whole number"},
      {"[output]\nevery_density = 1.5\n", "output.every_density: 1.5 is out of range"},
      {"[output]\nsnapshots = 0\n", "allowed is true or false"},
      {"[output]\nevery_time = \"-1 h\"\n", "output.every_time: \"-1 h\" is out of range"},
  };
  for (const auto& sample : samples) expect_one_fault(sample);
}

TEST(WrongCase, PackingsAndMaterials) {
  const std::string rest = "[stop]\ntime = 1\n[material]\nuse = \"copper\"\n[packing]\n";
  const WrongCase packings[] = {
      {"", "case.toml:5: packing: missing; allowed is either packing.file or packing.generate"},
      {"file = \"a\"\ngenerate = \"simple-cubic\"\n", "packing.generate: there is packing.file too"},
      {"generate = \"cubic\"\n", "packing.generate: \"cubic\" is unknown"},
      {"generate = \"random-sequential\"\n", "\"random-sequential\" is not available yet"},
      {"generate = \"gas-compacted\"\n", "\"gas-compacted\" is not available yet"},
      {"generate = \"deposit\"\n", "\"deposit\" is not available yet"},
      {"file = \"\"\n", "an empty or impossible file name"},
      {"file = \"a\\u0000b\"\n", "an empty or impossible file name"},
      {"file = 3\n", "packing.file: 3 does not fit; allowed is a file name"},
      {"file = \"a\"\nradius = \"6 um\"\n", "packing.radius: means nothing here, only with packing.generate"},
      {"generate = \"random-dense\"\ncontacts = \"b\"\n", "only with packing.file; leave it out"},
      {"generate = \"random-dense\"\ncount = 0\n", "packing.count: 0 is out of range"},
      {"generate = \"random-dense\"\ncount = 1e4\n", "10000 does not fit; allowed is a whole number"},
      {"generate = \"random-dense\"\nradius = \"5 kg\"\n",
       "this is a mass; a length is wanted, e.g. \"5 um\""},
      {"generate = \"random-dense\"\nradius = -1\n", "allowed: above 0 m"},
      {"generate = \"random-dense\"\nrelative_density = 0.59\n", "allowed: at least 0.6, at most 0.66"},
      {"generate = \"random-dense\"\nrelative_density = 0.67\n", "0.67 is out of range"},
      {"generate = \"random-dense\"\nradius_spread = 1\n", "allowed: at least 0, below 1"},
      {"generate = \"random-dense\"\nseed = -1\n", "packing.seed: -1 is out of range"},
      {"generate = \"simple-cubic\"\nradius_spread = 0.1\n",
       "only with packing.generate = \"random-dense\"; allowed: 0.0"},
      {"generate = \"simple-cubic\"\nrelative_density = 0.65\n",
       "packing.relative_density: means nothing here"},
  };
  for (const auto& sample : packings) expect_one_fault(sample, rest);
  const std::string no_material = "packing.generate = \"simple-cubic\"\nstop.time = 1\n[material]\n";
  const std::string all = "density=1\nsurface_energy=1\natomic_volume=1\nboundary_diffusion.prefactor=1\n";
  const WrongCase materials[] = {
      {"use = \"coper\"\n", "case.toml:4: material.use: \"coper\" is unknown; did you mean copper?"},
      {"use = 3\n", "material.use: 3 does not fit"},
      {"use = \"copper\"\ndensity = 0\n", "allowed: above 0 kg/m^3"},
      {"use = \"copper\"\ndihedral_angle = \"181 deg\"\n",
       "out of range; allowed: above 0 rad, at most 3.14"},
      {all + "dihedral_angle = 3\n", "material.boundary_diffusion.activation_energy: missing"},
      {"use = \"copper\"\nboundary_diffusion = 3\n",
       "allowed is [material.boundary_diffusion] with its keys"},
  };
  for (const auto& sample : materials) expect_one_fault(sample, no_material);
}

TEST(WrongCase, KeysThatDoNotGoTogether) {
  const std::string periodic = "[cell]\nkind = \"periodic\"\n";
  const WrongCase samples[] = {
      {"[cell]\nstress = \"1 MPa\"\n", "cell.stress: means nothing here, only with cell.kind = \"periodic\""},
      {"[cell]\nstrain_rate = [0, 0, 1]\n", "cell.strain_rate: means nothing here"},
      {"[cell]\nsize = [1, 1, 1]\n", "cell.size: means nothing here"},
      {periodic + "size = [1, 1, 1]\n", "only with cell.kind = \"periodic\" and packing.file; leave it out"},
      {periodic + "stress = 0\nstrain_rate = [0, 0, 1]\n", "cell.strain_rate: there is cell.stress too"},
      {periodic + "stress = [0, 0]\n", "a list of 2 does not fit"},
      {periodic + "strain_rate = 1\n", "cell.strain_rate: 1 does not fit; allowed is a list of 3"},
      {periodic + "stress = [0, 0, \"1 m\"]\n", "this is a length; a stress is wanted"},
      {"[method]\nsmallest_step = 2\nlargest_step = 1\n",
       "method.smallest_step: 2 s is above method.largest_step"},
      {"[method]\ntime_step = 1\nlargest_step = 1\n", "means nothing beside a fixed method.time_step"},
      {"[[particles]]\nfixed = true\n", "particles[0].ids: missing"},
      {"[[particles]]\nids = []\n", "a list of 0 does not fit"},
      {"[[particles]]\nids = [-1]\n", "case.toml:8: particles[0].ids: -1 is out of range"},
      {"[[particles]]\nids = [1.5]\n", "1.5 does not fit"},
      {"[[particles]]\nids = [1]\n[[particles]]\nids = [1]\n", "particle 1 is named before, in particles[0]"},
      {"[[particles]]\nids = [1, 1]\n", "particle 1 is named before"},
      {"[particles]\nids = [1]\n", "particles: a list of tables is wanted"},
      {"[[particles]]\nids = [1]\nforce = \"1 N\"\n", "particles[0].force: \"1 N\" does not fit"},
      {"[[particles]]\nids = [1]\nfroce = 1\n", "particles[0].froce: unknown key; did you mean force?"},
  };
  for (const auto& sample : samples) expect_one_fault(sample);
  expect_one_fault({"cell.kind = \"periodic\"\n", "cell.size: missing"},
                   "packing.file = \"a\"\nstop.time = 1\nmaterial.use = \"copper\"\n");
  expect_one_fault({"", "case.toml: stop: missing; at least one"},
                   "packing.file = \"a\"\nmaterial.use = \"copper\"\n");
  expect_one_fault({"", "stop.time: 0 is out of range"},
                   "packing.file = \"a\"\nmaterial.use = \"copper\"\nstop.time = 0\n");
}

TEST(WrongCase, TemperatureProgrammes) {
  const auto program = [](const std::string& steps) { return "[temperature]\nprogram = " + steps + "\n"; };
  const WrongCase samples[] = {
      {program("[{ rate = 0, to = 1000 }]"), "temperature.program[0].rate: a ramp of rate 0 never arrives"},
      {program("[{ rate = -1, to = 2000 }]"), "a negative rate does not heat from 1323.15 K to 2000 K"},
      {program("[{ rate = 1 }]"), "temperature.program[0]: allowed is either a ramp"},
      {program("[{ to = 1000 }]"), "allowed is either a ramp"},
      {program("[{}]"), "allowed is either a ramp"},
      {program("[{ rate = 1, to = 1000, hold = 1 }]"), "allowed is either a ramp"},
      {program("[{ hold = \"1 h\" }, { hold = 0 }]"),
       "case.toml:8: temperature.program[1].hold: 0 is out of range"},
      {program("[{ rate = \"10 degC/min\", to = 1000 }]"), "write K here, e.g. \"10 K/min\""},
      {program("[3]"), "temperature.program[0]: a list of tables is wanted"},
      {program("3"), "temperature.program: a list of tables is wanted"},
      {program("[{ hold = 1, unti = 3 }]"), "temperature.program[0].unti: unknown key"},
  };
  for (const auto& sample : samples) expect_one_fault(sample);
}

TEST(WrongCase, KeysAndValuesNotAvailableYet) {
  const WrongCase samples[] = {
      {"[[wall]]\nx = 1\n", "case.toml:7: wall: not available yet"},
      {"[load]\ngravity = 9.81\n", "load: not available yet"},
      {"[[particles]]\nids = [1]\ninert = true\n", "particles[0].inert: not available yet"},
  };
  for (const auto& sample : samples) expect_one_fault(sample);
  EXPECT_TRUE(faults_of(least_case + "[method]\ndensity_factor = 1.0\n").empty());
}

TEST(WrongCase, UnknownKeysNameTheNearest) {
  const WrongCase samples[] = {
      {"[contact]\nsliding_resistence = 0.1\n",
       "contact.sliding_resistence: unknown key; did you mean sliding_resistance?; allowed here: attraction"},
      {"[contcat]\npull = 1\n", "case.toml:7: contcat: unknown key; did you mean contact?"},
      {"[method]\nsliding_resistance = 0.1\n", "did you mean contact.sliding_resistance?"},
      {"[method]\nzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzzz = 0.1\n", "unknown key; allowed here: name, inertia"},
      {"[contact.pull]\nx = 1\n", "contact.pull: a table does not fit"},
      {"[method]\ndensity_factor = 1e12\n", "only with method.name = \"verlet\"; allowed: 1"},
      {"[method]\nname = \"quasi-static\"\ncell_inertia = 2\n", "only with method.name = \"verlet\""},
      {"[method]\nname = \"verlet\"\nsolver = \"gauss-seidel\"\n", "not with method.name = \"verlet\""},
      {"[method]\nname = \"verlet\"\naccuracy = 0.1\n", "not with method.name = \"verlet\""},
      {"[temperature]\n\"a b\" = 1\n", "temperature.a b: unknown key"},
  };
  for (const auto& sample : samples) expect_one_fault(sample);
}

TEST(WrongCase, AllFaultsAreToldTogetherInTheOrderOfTheFile) {
  const auto faults = faults_of(
      "titel = \"x\"\n"
      "[packing]\n"
      "generate = \"random-dense\"\n"
      "radius = \"5 kg\"\n"
      "[contact]\n"
      "spins = \"no\"\n"
      "[method]\n"
      "name = \"verlett\"\n",
      {"method.accuracy=7", "nonsense"});
  ASSERT_EQ(faults.size(), 13U) << all_of(faults);
  const auto text = all_of(faults);
  EXPECT_EQ(faults[0],
            "case.toml: material.density: missing; allowed is a density with its unit, e.g. "
            "\"8960 kg/m^3\", or a number in kg/m^3; or start from a material, e.g. use = \"copper\"");
  std::size_t last = 0;
  for (const auto* part :
       {"material.density", "case.toml: stop: missing", "case.toml:1: titel", "case.toml:4: packing",
        "case.toml:6: contact.spins", "case.toml:8: method.name",
        "--set method.accuracy=7: method.accuracy: 7 is out of range", "--set nonsense: no value"}) {
    const auto at = text.find(part);
    ASSERT_NE(at, text.npos) << part << "\n" << text;
    EXPECT_GE(at, last) << part;
    last = at;
  }
}

}  // namespace
}  // namespace frit::config
