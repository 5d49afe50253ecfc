#include "report/colour_map.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace frit::report {
namespace {

// A colour of CIE L*a*b* in polar form; `lightness` in 0 to 100, `hue` in degrees.
struct Polar {
  double lightness, chroma, hue;
};

double from_linear(double light) {
  const double inside = std::clamp(light, 0.0, 1.0);
  return inside <= 0.0031308 ? 12.92 * inside : 1.055 * std::pow(inside, 1.0 / 2.4) - 0.055;
}

double inverse_f(double t) {
  constexpr double delta = 6.0 / 29.0;
  return t > delta ? t * t * t : 3.0 * delta * delta * (t - 4.0 / 29.0);
}

// CIE 15 for L*a*b* with white D65, IEC 61966-2-1 for sRGB; what sRGB lacks is cut off.
Rgb to_rgb(const Polar& colour) {
  const double angle = colour.hue * std::numbers::pi / 180.0;
  const double y = (colour.lightness + 16.0) / 116.0;
  const double X = 0.95047 * inverse_f(y + colour.chroma * std::cos(angle) / 500.0);
  const double Y = inverse_f(y);
  const double Z = 1.08883 * inverse_f(y - colour.chroma * std::sin(angle) / 200.0);
  const std::array<double, 3> linear{3.2404542 * X - 1.5371385 * Y - 0.4985314 * Z,
                                     -0.9692660 * X + 1.8760108 * Y + 0.0415560 * Z,
                                     0.0556434 * X - 0.2040259 * Y + 1.0572252 * Z};
  Rgb rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<std::uint8_t>(std::lround(255.0 * from_linear(linear[c])));
  return rgb;
}

// Evenly spaced control points, joined by straight lines.
template <std::size_t count>
ColourTable table_of(const std::array<Polar, count>& points) {
  ColourTable table{};
  for (std::size_t n = 0; n < table.size(); ++n) {
    const double place = static_cast<double>(n) / 255.0 * (count - 1);
    const auto left = std::min(static_cast<std::size_t>(place), count - 2);
    const double part = place - static_cast<double>(left);
    const auto mix = [&](double Polar::*member) {
      return (1.0 - part) * points[left].*member + part * points[left + 1].*member;
    };
    table[n] = to_rgb({mix(&Polar::lightness), mix(&Polar::chroma), mix(&Polar::hue)});
  }
  return table;
}

// Blue and yellow only, through grey: chroma changes its sign.
ColourTable dusk_table() {
  return table_of(std::array<Polar, 3>{Polar{15, -28, 98}, Polar{52.5, 4, 92}, Polar{90, 52, 96}});
}

}  // namespace

std::span<const ColourMap> colour_maps() {
  static const std::array<ColourMap, 3> maps{{
      // Chosen so that neighbours differ equally (0.77 of CIE 1976 from one entry to the next).
      {"lagoon", table_of(std::array<Polar, 6>{Polar{16, 40, 338}, Polar{31, 42, 288}, Polar{46, 24, 236},
                                               Polar{61, 26, 152}, Polar{76, 62, 137}, Polar{91, 66, 104}})},
      {"dusk", dusk_table()},
      {"grey", table_of(std::array<Polar, 2>{Polar{12, 0, 0}, Polar{94, 0, 0}})},
  }};
  return maps;
}

}  // namespace frit::report
