#include <gtest/gtest.h>

#include "samples.hpp"

namespace frit::config {
namespace {

Case read(const std::vector<std::string>& overrides) {
  return parse_case(least_case, "case.toml", overrides);
}

TEST(Overrides, ReplaceAddAndTakeTomlOrBareWords) {
  const Case whole =
      read({"stop.time=30 min", "contact.spins=blocked", "method.accuracy = 1e-3",
            "contact.neck_bending=true", "packing.seed=7", "title=\"a = b\"", "cell={ kind = \"periodic\" }",
            "material.boundary_diffusion.prefactor=\"1e-15 m^3/s\""});
  EXPECT_EQ(whole.stop.time, 1800.0);
  EXPECT_EQ(whole.contact.spins, Spins::blocked);
  EXPECT_EQ(whole.method.accuracy, 1e-3);
  EXPECT_TRUE(whole.contact.neck_bending);
  EXPECT_EQ(whole.packing.seed, 7);
  EXPECT_EQ(whole.title, "a = b");
  EXPECT_EQ(whole.cell.kind, CellKind::periodic);
  EXPECT_EQ(whole.material.boundary_diffusion.prefactor, 1e-15);
  EXPECT_EQ(whole.material.density, 8960.0);
}

TEST(Overrides, OfTheMaterialBringItsProperties) {
  EXPECT_EQ(read({"material.use=alumina"}).material.density, 3980.0);
}

TEST(Overrides, TheLastOfOneKeyWins) { EXPECT_EQ(read({"stop.time=1", "stop.time=2"}).stop.time, 2.0); }

TEST(Overrides, MayFillAnEmptyCase) {
  const Case whole =
      parse_case("", "case.toml", {"packing.generate=simple-cubic", "material.use=copper", "stop.time=1"});
  EXPECT_EQ(whole.packing.generate, Generator::simple_cubic);
}

TEST(Overrides, TakeListsWhole) {
  const Case whole =
      read({"temperature.program=[{ hold = \"1 h\" }]", "particles=[{ ids = [2], fixed = true }]"});
  EXPECT_EQ(whole.temperature.program.at(0).hold, 3600.0);
  EXPECT_EQ(whole.particles.at(0).ids, std::vector<std::int64_t>{2});
}

TEST(Overrides, FaultsNameTheOverride) {
  const std::pair<std::string, std::string> samples[] = {
      {"stop.time=5 kg", "--set stop.time=5 kg: stop.time: \"5 kg\": this is a mass; a time is wanted"},
      {"stop.tiem=5", "--set stop.tiem=5: stop.tiem: unknown key; did you mean time?"},
      {"stop.time", "--set stop.time: no value; allowed is key=value"},
      {"=5", "--set =5: no value"},
      {"stop.time.x=5", "stop.time.x: \"time\" is not a table here"},
      {"title=\"open", "--set title=\"open: title: not TOML: a string is not closed"},
      {"temperature.program=[{ hold = 1 }", "temperature.program: not TOML"},
      {"method.accuracy=fine", "\"fine\" does not fit; allowed is a number"},
      {"stop.time=1\n[contact]", "stop.time: "},
      {"contact..pull=1", "contact..pull: an empty name"},
      {"stop.time=", "stop.time: \"\": no number in front"},
  };
  for (const auto& [text, part] : samples) {
    const auto faults = faults_of(least_case, {text});
    ASSERT_EQ(faults.size(), 1U) << text << "\n" << all_of(faults);
    EXPECT_NE(faults[0].find(part), std::string::npos) << faults[0];
  }
}

}  // namespace
}  // namespace frit::config
