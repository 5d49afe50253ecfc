#include "report/case_words.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "config/case_reader.hpp"

namespace frit::report {
namespace {

constexpr const char* text = R"(
[packing]
generate = "random-dense"
count = 500
radius = "2.5 um"
[cell]
kind = "periodic"
stress = "-1 MPa"
[material]
use = "copper"
surface_energy = "2 J/m^2"
[temperature]
start = "600 degC"
program = [{ rate = "10 K/min", to = "900 degC" }, { hold = "90 min" }]
[stop]
time = "3 h"
)";

TEST(CaseInWords, NamesWhatTheCaseSays) {
  std::string all;
  for (const auto& sentence : case_in_words(config::parse_case(text, "test"), 500)) all += sentence + " ";
  for (const char* part : {"500 copper spheres", "2.5 µm", "-1, -1, -1) MPa", "600 °C", "900 °C at 10 K/min",
                           "held for 1.5 h", "until 3 h", "Bouvard"}) {
    EXPECT_NE(all.find(part), all.npos) << part << " in: " << all;
  }
}

TEST(CaseInWords, SaysWhatExplicitDynamicsDoesToTheMass) {
  const std::string verlet = std::string(text) + "[method]\nname = \"verlet\"\ndensity_factor = 1e12\n";
  EXPECT_EQ(case_in_words(config::parse_case(verlet, "test"), 500).back(),
            "Explicit dynamics (velocity Verlet) with 1e+12 times the real density, steps at the limit of "
            "stability.");
}

TEST(MaterialOf, TellsWhatTheCaseOverrides) {
  const auto material = material_of(config::parse_case(text, "test"));
  const std::string source = material["source"];
  EXPECT_NE(source.find("surface energy"), source.npos);
  EXPECT_EQ(source.find("density"), source.npos);
  EXPECT_TRUE(material["properties"].is_array());
}

TEST(ShortTexts, TakeTheUnitThatSuits) {
  EXPECT_EQ(short_length(5e-6), "5 µm");
  EXPECT_EQ(short_length(2.5e-9), "2.5 nm");
  EXPECT_EQ(short_time(2282.3), "38.04 min");
  EXPECT_EQ(short_time(0.0), "0 s");
  EXPECT_EQ(short_temperature(1323.15), "1050 °C");
}

}  // namespace
}  // namespace frit::report
