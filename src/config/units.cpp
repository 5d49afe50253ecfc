#include "config/units.hpp"

#include <fmt/core.h>

#include <array>
#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <system_error>

#include "core/constants.hpp"
#include "core/error.hpp"

namespace frit::config {
namespace {

constexpr std::array<QuantityInfo, 15> quantities{{
    {Quantity::number, "a plain number", "", "0.5", {}},
    {Quantity::length, "a length", "m", "5 um", {.length = 1}},
    {Quantity::time, "a time", "s", "2 h", {.time = 1}},
    {Quantity::temperature, "a temperature", "K", "1050 degC", {.temperature = 1}},
    {Quantity::temperature_rate, "a heating rate", "K/s", "10 K/min", {.time = -1, .temperature = 1}},
    {Quantity::stress, "a stress", "Pa", "1 MPa", {.length = -1, .mass = 1, .time = -2}},
    {Quantity::strain_rate, "a strain rate", "1/s", "-1e-4 1/s", {.time = -1}},
    {Quantity::force, "a force", "N", "1 uN", {.length = 1, .mass = 1, .time = -2}},
    {Quantity::mass, "a mass", "kg", "1 mg", {.mass = 1}},
    {Quantity::density, "a density", "kg/m^3", "8960 kg/m^3", {.length = -3, .mass = 1}},
    {Quantity::surface_energy, "a surface energy", "J/m^2", "1.72 J/m^2", {.mass = 1, .time = -2}},
    {Quantity::angle, "an angle", "rad", "146 deg", {.angle = 1}},
    {Quantity::volume, "a volume", "m^3", "1.18e-29 m^3", {.length = 3}},
    {Quantity::boundary_diffusion,
     "a boundary diffusion prefactor",
     "m^3/s",
     "5.12e-15 m^3/s",
     {.length = 3, .time = -1}},
    {Quantity::molar_energy,
     "an energy per mole",
     "J/mol",
     "105 kJ/mol",
     {.length = 2, .mass = 1, .time = -2, .amount = -1}},
}};

// scale = 10^power * up / down. Two factors instead of one keep "10 K/min" the double nearest to 10/60.
struct Unit {
  int power = 0;
  double up = 1.0, down = 1.0;
  Dimension dimension;
};

struct Symbol {
  std::string_view name;
  Unit unit;
};

constexpr Dimension energy_dimension{.length = 2, .mass = 1, .time = -2};

constexpr std::array symbols{
    Symbol{"m", {0, 1, 1, {.length = 1}}},
    Symbol{"g", {-3, 1, 1, {.mass = 1}}},
    Symbol{"s", {0, 1, 1, {.time = 1}}},
    Symbol{"K", {0, 1, 1, {.temperature = 1}}},
    Symbol{"mol", {0, 1, 1, {.amount = 1}}},
    Symbol{"rad", {0, 1, 1, {.angle = 1}}},
    Symbol{"N", {0, 1, 1, {.length = 1, .mass = 1, .time = -2}}},
    Symbol{"Pa", {0, 1, 1, {.length = -1, .mass = 1, .time = -2}}},
    Symbol{"J", {0, 1, 1, energy_dimension}},
};

// Units that take no prefix.
constexpr std::array whole_symbols{
    Symbol{"1", {}},
    Symbol{"min", {0, 60, 1, {.time = 1}}},
    Symbol{"h", {0, 3600, 1, {.time = 1}}},
    Symbol{"day", {0, 86400, 1, {.time = 1}}},
    Symbol{"deg", {0, pi, 180, {.angle = 1}}},
};

struct Prefix {
  std::string_view name;
  int power;
};

constexpr std::array prefixes{Prefix{"f", -15}, Prefix{"p", -12}, Prefix{"n", -9}, Prefix{"u", -6},
                              Prefix{"µ", -6},  Prefix{"μ", -6},  Prefix{"m", -3}, Prefix{"c", -2},
                              Prefix{"k", 3},   Prefix{"M", 6},   Prefix{"G", 9},  Prefix{"T", 12}};

std::optional<Unit> find_symbol(std::string_view name) {
  for (const auto& symbol : whole_symbols)
    if (symbol.name == name) return symbol.unit;
  for (const auto& symbol : symbols)
    if (symbol.name == name) return symbol.unit;
  for (const auto& prefix : prefixes) {
    if (!name.starts_with(prefix.name)) continue;
    for (const auto& symbol : symbols) {
      if (symbol.name != name.substr(prefix.name.size())) continue;
      Unit unit = symbol.unit;
      unit.power += prefix.power;
      return unit;
    }
  }
  return std::nullopt;
}

// A product so far, times `factor` to the power `exponent`.
void multiply(Unit& product, const Unit& factor, int exponent) {
  product.power += factor.power * exponent;
  for (int n = 0; n < std::abs(exponent); ++n) {
    product.up *= exponent > 0 ? factor.up : factor.down;
    product.down *= exponent > 0 ? factor.down : factor.up;
  }
  product.dimension.length += factor.dimension.length * exponent;
  product.dimension.mass += factor.dimension.mass * exponent;
  product.dimension.time += factor.dimension.time * exponent;
  product.dimension.temperature += factor.dimension.temperature * exponent;
  product.dimension.amount += factor.dimension.amount * exponent;
  product.dimension.angle += factor.dimension.angle * exponent;
}

std::string_view trim(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

// Splits "m^3" (or "m3", "s^-1") into symbol and exponent; no exponent where it is malformed.
struct Factor {
  std::string_view symbol;
  std::optional<int> exponent = 1;
};
Factor split_factor(std::string_view text) {
  if (text == "1") return {text};
  const auto end = text.find_first_of("^-0123456789");
  if (end == std::string_view::npos) return {text};
  auto digits = text.substr(end);
  if (digits.starts_with('^')) digits.remove_prefix(1);
  int exponent = 0;
  const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
  const bool good = error == std::errc() && stop == digits.data() + digits.size() && std::abs(exponent) <= 9;
  return {text.substr(0, end), good ? std::optional(exponent) : std::nullopt};
}

std::string unknown_unit(std::string_view factor, const QuantityInfo& wanted) {
  if (factor == "C" || factor == "°C" || factor == "degc") return "unknown unit \"°C\"; write degC or K";
  return fmt::format("unknown unit \"{}\"; {} is wanted, e.g. \"{}\"", factor, wanted.name, wanted.example);
}

Unit parse_unit(std::string_view text, const QuantityInfo& wanted) {
  Unit product;
  int sign = 1;
  while (true) {
    const auto end = text.find_first_of("*/");
    const auto written = trim(text.substr(0, end));
    const Factor factor = split_factor(written);
    if (factor.symbol == "degC")
      throw InputError(
          "degC has an offset and stands only alone, for a temperature; write K here, e.g. \"10 K/min\"");
    const auto unit = find_symbol(factor.symbol);
    if (!unit || !factor.exponent) throw InputError(unknown_unit(written, wanted));
    multiply(product, *unit, sign * *factor.exponent);
    if (end == std::string_view::npos) return product;
    sign = text[end] == '/' ? -1 : 1;
    text.remove_prefix(end + 1);
  }
}

std::string name_of(const Dimension& dimension) {
  for (const auto& known : quantities)
    if (known.dimension == dimension) return std::string(known.name);
  return "something else";
}

// The number `digits` (as std::from_chars takes it, no sign "+") times 10^power, rounded once.
double scaled_number(std::string_view digits, int power) {
  std::string text(digits);
  int exponent = power;
  if (const auto mark = text.find_first_of("eE"); mark != std::string::npos) {
    const char* begin = text.data() + mark + 1;
    if (*begin == '+') ++begin;
    int own = 0;
    const auto [stop, error] = std::from_chars(begin, text.data() + text.size(), own);
    if (error != std::errc() || std::abs(own) > 10000)
      throw InputError("the number is too large or too small");
    exponent += own;
    text.resize(mark);
  }
  text += fmt::format("e{}", exponent);
  double value = 0.0;
  const auto [stop, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc()) throw InputError("the number is too large or too small");
  return value;
}

}  // namespace

const QuantityInfo& info(Quantity quantity) { return quantities[static_cast<std::size_t>(quantity)]; }

double parse_quantity(std::string_view text, Quantity wanted_quantity) {
  const QuantityInfo& wanted = info(wanted_quantity);
  const auto complain = [&](const std::string& what) {
    return InputError(fmt::format("\"{}\": {}", text.substr(0, 80), what));
  };
  auto rest = trim(text);
  if (rest.starts_with('+') && !rest.starts_with("+-")) rest.remove_prefix(1);
  double bare = 0.0;
  const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), bare);
  if (error == std::errc::invalid_argument)
    throw complain(fmt::format("no number in front; {} is wanted, e.g. \"{}\"", wanted.name, wanted.example));
  if (error == std::errc() && !std::isfinite(bare)) throw complain("not a finite number");
  const auto digits = rest.substr(0, static_cast<std::size_t>(stop - rest.data()));
  auto unit_text = trim(rest.substr(digits.size()));
  try {
    if (unit_text.empty()) return scaled_number(digits, 0);
    if (unit_text == "degC" && wanted_quantity == Quantity::temperature)
      return scaled_number(digits, 0) + celsius_zero;
    const std::string numerator = unit_text.starts_with('/') ? "1" : "";
    const Unit unit = parse_unit(numerator + std::string(unit_text), wanted);
    if (unit.dimension != wanted.dimension)
      throw InputError(fmt::format("this is {}; {} is wanted, e.g. \"{}\"", name_of(unit.dimension),
                                   wanted.name, wanted.example));
    return scaled_number(digits, unit.power) * unit.up / unit.down;
  } catch (const InputError& fault) {
    throw complain(fault.what());
  }
}

}  // namespace frit::config
