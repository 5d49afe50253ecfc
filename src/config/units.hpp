// Quantities with units, as a user writes them ("5 um", "10 K/min"), into SI numbers with a dimension check.
#pragma once

#include <cstdint>
#include <string_view>

namespace frit::config {

// Exponents of metre, kilogram, second, kelvin, mole and radian. The radian counts, so that an angle
// cannot stand where a plain number is wanted.
struct Dimension {
  int length = 0, mass = 0, time = 0, temperature = 0, amount = 0, angle = 0;
  friend bool operator==(const Dimension&, const Dimension&) = default;
};

// What a key of the case file may measure.
enum class Quantity : std::uint8_t {
  number,  // dimensionless
  length,
  time,
  temperature,
  temperature_rate,
  stress,
  strain_rate,
  force,
  mass,
  density,
  surface_energy,
  angle,
  volume,
  boundary_diffusion,  // delta_b D_b
  molar_energy,
};

struct QuantityInfo {
  Quantity quantity;
  std::string_view name;     // with its article: "a length"
  std::string_view unit;     // SI, as frit writes it: "m"; empty for a number
  std::string_view example;  // "5 um"
  Dimension dimension;
};

const QuantityInfo& info(Quantity quantity);

// The value of `text` in SI: a number, or a number and a unit. Powers of ten are folded into the number
// before it is rounded, so "5 um" and 5e-6 are the same bits. "degC" is allowed for temperatures only, and
// only alone. Throws InputError with one fault: no number, not finite, unknown unit, wrong dimension.
double parse_quantity(std::string_view text, Quantity wanted);

}  // namespace frit::config
