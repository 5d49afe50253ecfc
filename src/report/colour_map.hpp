// Colour maps of our own for one quantity: lightness grows evenly from dark to light, so that equal
// differences look equal, grey prints keep the order, and no order rests on telling red from green.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

namespace frit::report {

using Rgb = std::array<std::uint8_t, 3>;  // sRGB
using ColourTable = std::array<Rgb, 256>;

struct ColourMap {
  std::string_view name;
  ColourTable table;  // from the least value to the largest
};

// "lagoon" (blue, green, yellow), "dusk" (blue, grey, yellow: the same to the colour-blind), "grey". The
// first is the default.
std::span<const ColourMap> colour_maps();

}  // namespace frit::report
