#include <fmt/core.h>
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "config/units.hpp"
#include "core/error.hpp"

namespace frit::config {
namespace {

constexpr int count = static_cast<int>(Quantity::molar_energy) + 1;

TEST(UnitsProperty, OnlyTheOwnDimensionIsTaken) {
  for (int given = 1; given < count; ++given) {
    const QuantityInfo& unit = info(static_cast<Quantity>(given));
    for (int wanted = 0; wanted < count; ++wanted) {
      const auto quantity = static_cast<Quantity>(wanted);
      const auto text = fmt::format("1 {}", unit.unit);
      if (info(quantity).dimension == unit.dimension) {
        EXPECT_EQ(parse_quantity(text, quantity), 1.0) << text;
      } else {
        EXPECT_THROW(parse_quantity(text, quantity), InputError) << text << " as " << info(quantity).name;
      }
    }
  }
}

TEST(UnitsProperty, BareNumbersReadBackToTheSameBits) {
  std::mt19937_64 random(3);
  for (int n = 0; n < 5000; ++n) {
    const double value = std::bit_cast<double>(random() & 0xFFEFFFFFFFFFFFFFULL);
    const double read = parse_quantity(fmt::format("{}", value), Quantity::stress);
    EXPECT_EQ(std::bit_cast<std::uint64_t>(read), std::bit_cast<std::uint64_t>(value)) << value;
  }
}

// A decimal moved by the prefix's power of ten is the decimal with another exponent, to the bit.
TEST(UnitsProperty, PrefixesMoveTheDecimalExponentExactly) {
  std::mt19937_64 random(4);
  for (int n = 0; n < 5000; ++n) {
    const auto digits = fmt::format("{}.{:06}", 1 + random() % 999, random() % 1000000);
    const int exponent = static_cast<int>(random() % 41) - 20;
    const double micro = parse_quantity(fmt::format("{}e{} uPa", digits, exponent), Quantity::stress);
    EXPECT_EQ(micro, std::stod(fmt::format("{}e{}", digits, exponent - 6))) << digits;
    const double cubed = parse_quantity(fmt::format("{}e{} um^3", digits, exponent), Quantity::volume);
    EXPECT_EQ(cubed, std::stod(fmt::format("{}e{}", digits, exponent - 18))) << digits;
  }
}

TEST(UnitsProperty, AnyTextIsReadOrRefused) {
  std::mt19937 random(5);
  const std::string letters = "0123456789+-.eE umkMGKPaNJshdegCol/^* \xC2\xB5\xFF";
  for (int n = 0; n < 20000; ++n) {
    std::string text;
    for (auto length = random() % 12; length > 0; --length) text += letters[random() % letters.size()];
    try {
      EXPECT_TRUE(std::isfinite(parse_quantity(text, static_cast<Quantity>(random() % count)))) << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.faults().size(), 1U);
    }
  }
}

}  // namespace
}  // namespace frit::config
