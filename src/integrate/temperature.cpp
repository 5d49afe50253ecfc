#include "integrate/temperature.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/constants.hpp"

namespace frit::integrate {
namespace {

// Gauss-Legendre, 8 points on [-1, 1] (Abramowitz & Stegun, table 25.4).
constexpr std::array<double, 4> gauss_node{0.1834346424956498, 0.5255324099163290, 0.7966664774136267,
                                           0.9602898564975363};
constexpr std::array<double, 4> gauss_weight{0.3626837833783620, 0.3137066458778873, 0.2223810344533745,
                                             0.1012285362903763};

}  // namespace

double BoundaryDiffusion::delta_b(double T) const {
  if (!(T > 0.0)) return 0.0;
  return atomic_volume * prefactor * std::exp(-activation_energy / (gas_constant * T)) /
         (boltzmann_constant * T);
}

Furnace::Furnace(const BoundaryDiffusion& diffusion, double start_temperature, const std::vector<Ramp>& ramps)
    : diffusion_(diffusion), knot_time_{0.0}, knot_temperature_{start_temperature} {
  for (const Ramp& ramp : ramps) {
    knot_temperature_.push_back(knot_temperature_.back() + ramp.rate * ramp.duration);
    knot_time_.push_back(knot_time_.back() + ramp.duration);
  }
}

double Furnace::temperature(double time) const {
  const auto after = std::upper_bound(knot_time_.begin(), knot_time_.end(), time);
  if (after == knot_time_.end()) return knot_temperature_.back();
  const auto n = static_cast<std::size_t>(after - knot_time_.begin());
  const double part = (time - knot_time_[n - 1]) / (knot_time_[n] - knot_time_[n - 1]);
  return knot_temperature_[n - 1] + part * (knot_temperature_[n] - knot_temperature_[n - 1]);
}

double Furnace::delta_b(double time) const { return diffusion_.delta_b(temperature(time)); }

// One linear stretch, in panels over which the Arrhenius exponent changes by at most 1.
double Furnace::theta_within(double begin, double end) const {
  const double T_begin = temperature(begin), T_end = temperature(end);
  if (T_begin == T_end) return diffusion_.delta_b(T_begin) * (end - begin);
  const double coldest = std::max(1.0, std::min(T_begin, T_end)), hottest = std::max(T_begin, T_end);
  const double exponent = diffusion_.activation_energy / gas_constant * (1.0 / coldest - 1.0 / hottest);
  const int panels = 1 + static_cast<int>(std::min(1e4, std::abs(exponent) + std::log(hottest / coldest)));
  const double half = 0.5 * (end - begin) / panels;
  double sum = 0.0;
  for (int panel = 0; panel < panels; ++panel) {
    const double middle = begin + (2 * panel + 1) * half;
    for (std::size_t n = 0; n < gauss_node.size(); ++n) {
      const double off = gauss_node[n] * half;
      sum += gauss_weight[n] * (delta_b(middle - off) + delta_b(middle + off));
    }
  }
  return sum * half;
}

double Furnace::theta(double begin, double end) const {
  double sum = 0.0, from = begin;
  for (const double knot : knot_time_) {
    if (knot <= from || knot >= end) continue;
    sum += theta_within(from, knot);
    from = knot;
  }
  return sum + theta_within(from, end);
}

double Furnace::duration_for(double begin, double wanted) const {
  double from = begin, left = wanted;
  for (const double knot : knot_time_) {
    if (knot <= from) continue;
    const double here = theta_within(from, knot);
    if (here >= left) break;
    left -= here;
    from = knot;
  }
  const double last = knot_time_.back();
  if (from >= last) {
    const double held = diffusion_.delta_b(knot_temperature_.back());
    return held > 0.0 ? (from - begin) + left / held : std::numeric_limits<double>::infinity();
  }
  double low = from, high = *std::upper_bound(knot_time_.begin(), knot_time_.end(), from);
  for (int halving = 0; halving < 200 && high - low > 1e-14 * high; ++halving) {
    const double middle = 0.5 * (low + high);
    (theta_within(from, middle) < left ? low : high) = middle;
  }
  return 0.5 * (low + high) - begin;
}

}  // namespace frit::integrate
