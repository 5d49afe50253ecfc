#include "config/units.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "core/constants.hpp"
#include "core/error.hpp"

namespace frit::config {
namespace {

struct GoodQuantity {
  const char* text;
  Quantity quantity;
  double value;
};

// The expected values are the doubles nearest to the exact decimal, so equality is to the bit.
TEST(Units, GiveTheNearestDoubleInSi) {
  const GoodQuantity samples[] = {
      {"5 um", Quantity::length, 5e-6},
      {"5um", Quantity::length, 5e-6},
      {"  5 \t um ", Quantity::length, 5e-6},
      {"5 µm", Quantity::length, 5e-6},
      {"5 μm", Quantity::length, 5e-6},
      {"+5 um", Quantity::length, 5e-6},
      {"0.1 mm", Quantity::length, 1e-4},
      {"3 nm", Quantity::length, 3e-9},
      {"7 pm", Quantity::length, 7e-12},
      {"2 cm", Quantity::length, 0.02},
      {"1e3 um", Quantity::length, 1e-3},
      {"1E+3 um", Quantity::length, 1e-3},
      {"5e-6", Quantity::length, 5e-6},
      {"1050 degC", Quantity::temperature, 1323.15},
      {"-10 degC", Quantity::temperature, 263.15},
      {"1323.15 K", Quantity::temperature, 1323.15},
      {"10 K/min", Quantity::temperature_rate, 10.0 / 60.0},
      {"600 K/h", Quantity::temperature_rate, 600.0 / 3600.0},
      {"-0.5 K/s", Quantity::temperature_rate, -0.5},
      {"2 h", Quantity::time, 7200.0},
      {"30 min", Quantity::time, 1800.0},
      {"1 day", Quantity::time, 86400.0},
      {"1 ms", Quantity::time, 1e-3},
      {"104 kJ/mol", Quantity::molar_energy, 104e3},
      {"5.12e-15 m^3/s", Quantity::boundary_diffusion, 5.12e-15},
      {"5.12e-15 m3/s", Quantity::boundary_diffusion, 5.12e-15},
      {"3 um^3 * s^-1", Quantity::boundary_diffusion, 3e-18},
      {"1 MPa", Quantity::stress, 1e6},
      {"1 N/mm^2", Quantity::stress, 1e6},
      {"-1 GPa", Quantity::stress, -1e9},
      {"1.72 J/m^2", Quantity::surface_energy, 1.72},
      {"1.72 N/m", Quantity::surface_energy, 1.72},
      {"0.1 1/s", Quantity::strain_rate, 0.1},
      {"0.1 /s", Quantity::strain_rate, 0.1},
      {"6 1/min", Quantity::strain_rate, 0.1},
      {"1 uN", Quantity::force, 1e-6},
      {"8.96 g/cm^3", Quantity::density, 8960.0},
      {"8960 kg/m^3", Quantity::density, 8960.0},
      {"1.18e-29 m^3", Quantity::volume, 1.18e-29},
      {"1 rad", Quantity::angle, 1.0},
      {"0.25", Quantity::number, 0.25},
  };
  for (const auto& [text, quantity, value] : samples)
    EXPECT_EQ(parse_quantity(text, quantity), value) << text;
}

TEST(Units, DegreesAreRadiansTimesPiOver180) {
  EXPECT_EQ(parse_quantity("180 deg", Quantity::angle), pi);
  EXPECT_NEAR(parse_quantity("146 deg", Quantity::angle), 2.5481807079117213, 1e-15);
}

TEST(Units, EveryPrefixScalesByItsPowerOfTen) {
  const std::pair<const char*, int> prefixes[] = {{"f", -15}, {"p", -12}, {"n", -9}, {"u", -6}, {"m", -3},
                                                  {"c", -2},  {"k", 3},   {"M", 6},  {"G", 9},  {"T", 12}};
  for (const auto& [prefix, power] : prefixes) {
    const double expected = std::stod("7e" + std::to_string(power));
    EXPECT_EQ(parse_quantity(std::string("7 ") + prefix + "Pa", Quantity::stress), expected) << prefix;
  }
}

TEST(Units, EveryExampleOfTheTableIsOfItsOwnDimension) {
  for (int n = 0; n <= static_cast<int>(Quantity::molar_energy); ++n) {
    const auto quantity = static_cast<Quantity>(n);
    EXPECT_EQ(info(quantity).quantity, quantity);
    EXPECT_NO_THROW(parse_quantity(info(quantity).example, quantity)) << info(quantity).example;
    if (info(quantity).unit.empty()) continue;
    EXPECT_EQ(parse_quantity("3 " + std::string(info(quantity).unit), quantity), 3.0) << info(quantity).unit;
  }
}

struct BadQuantity {
  const char* text;
  Quantity quantity;
  const char* message;
};

TEST(Units, SayWhatIsWrong) {
  const BadQuantity samples[] = {
      {"5 kg", Quantity::length, "this is a mass; a length is wanted, e.g. \"5 um\""},
      {"5 s", Quantity::length, "this is a time"},
      {"5 um", Quantity::time, "this is a length"},
      {"5 m^7", Quantity::length, "this is something else"},
      {"146 deg", Quantity::number, "this is an angle; a plain number is wanted"},
      {"5 furlong", Quantity::length, "unknown unit \"furlong\""},
      {"5 um^x", Quantity::length, "unknown unit \"um^x\""},
      {"5 m^", Quantity::length, "unknown unit \"m^\""},
      {"5 m^99999999999", Quantity::length, "unknown unit"},
      {"5 J/(mol)", Quantity::molar_energy, "unknown unit \"(mol)\""},
      {"5 m//s", Quantity::length, "unknown unit \"\""},
      {"5 m/", Quantity::length, "unknown unit \"\""},
      {"1050 C", Quantity::temperature, "write degC or K"},
      {"1050 °C", Quantity::temperature, "write degC or K"},
      {"10 degC/min", Quantity::temperature_rate, "write K here"},
      {"10 degC", Quantity::length, "stands only alone, for a temperature"},
      {"um", Quantity::length, "no number in front"},
      {"", Quantity::length, "no number in front"},
      {"five um", Quantity::length, "no number in front"},
      {"J/m^2", Quantity::surface_energy, "no number in front"},
      {"+-5 um", Quantity::length, "no number in front"},
      {"inf m", Quantity::length, "not a finite number"},
      {"nan", Quantity::length, "not a finite number"},
      {"1e999 m", Quantity::length, "too large or too small"},
      {"1e307 km", Quantity::length, "too large or too small"},
      {"1e-999 m", Quantity::length, "too large or too small"},
      {"1e99999999999 m", Quantity::length, "too large or too small"},
      {"1,5 um", Quantity::length, "unknown unit \",5 um\""},
      {"1.5.2 um", Quantity::length, "unknown unit"},
  };
  for (const auto& [text, quantity, message] : samples) {
    try {
      const double value = parse_quantity(text, quantity);
      ADD_FAILURE() << text << " was taken as " << value;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(message), std::string::npos) << text << ": " << error.what();
    }
  }
}

}  // namespace
}  // namespace frit::config
