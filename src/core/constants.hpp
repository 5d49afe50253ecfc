// Physical and mathematical constants (SI, exact values of the 2019 definitions).
#pragma once

#include <numbers>

namespace frit {

inline constexpr double pi = std::numbers::pi;
inline constexpr double boltzmann_constant = 1.380649e-23;  // [J/K]
inline constexpr double gas_constant = 8.31446261815324;    // [J/(mol K)]
inline constexpr double celsius_zero = 273.15;              // [K]

}  // namespace frit
