#include "observe/necks.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "core/contract.hpp"

namespace frit::observe {
namespace {

// Values that are not known (NaN) leave the share without a value.
template <class Predicate>
double share_of(const std::vector<double>& values, Predicate&& holds) {
  const auto is_unknown = [](double value) { return std::isnan(value); };
  if (values.empty() || std::any_of(values.begin(), values.end(), is_unknown)) return no_value;
  return static_cast<double>(std::count_if(values.begin(), values.end(), holds)) /
         static_cast<double>(values.size());
}

}  // namespace

std::vector<double> neck_ratios(const State& state, const NeckLaw& law) {
  FRIT_EXPECT(law.neck_radius.empty() || law.neck_radius.size() == state.contacts.size());
  const auto& radius = state.particles.radius;
  std::vector<double> ratios(law.neck_radius.size());
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    const double r_i = radius[state.contacts.i[k]], r_j = radius[state.contacts.j[k]];
    ratios[k] = law.neck_radius[k] / equivalent_radius(r_i, r_j);
  }
  return ratios;
}

std::vector<double> relative_sliding(const State& state) {
  const auto& radius = state.particles.radius;
  const Contacts& contacts = state.contacts;
  std::vector<double> ratios(contacts.size());
  for (std::size_t k = 0; k < ratios.size(); ++k) {
    ratios[k] = contacts.sliding_path[k] / equivalent_radius(radius[contacts.i[k]], radius[contacts.j[k]]);
  }
  return ratios;
}

std::vector<double> coordination_numbers(const State& state) {
  std::vector<double> numbers(state.particles.size(), 0.0);
  for (const std::int32_t i : state.contacts.i) numbers[i] += 1.0;
  for (const std::int32_t j : state.contacts.j) numbers[j] += 1.0;
  return numbers;
}

NeckStatistics neck_statistics(const State& state, const NeckLaw& law) {
  const auto contacts = static_cast<double>(state.contacts.size());
  const auto particles = static_cast<double>(state.particles.size());
  return {
      .contacts = state.contacts.size(),
      .coordination = particles > 0.0 ? 2.0 * contacts / particles : no_value,
      .rattlers = share_of(coordination_numbers(state), [](double number) { return number == 0.0; }),
      .thinning = share_of(state.contacts.approach_velocity, [](double velocity) { return velocity < 0.0; }),
      .neck_ratio = distribution_of(neck_ratios(state, law))};
}

double sliding_dissipation_share(const Contacts& contacts, const NeckLaw& law) {
  if (law.normal_resistance.empty() || law.sliding_resistance.empty()) return no_value;
  FRIT_EXPECT(law.normal_resistance.size() == contacts.size());
  FRIT_EXPECT(law.sliding_resistance.size() == contacts.size());
  double normal = 0.0, sliding = 0.0;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    normal += law.normal_resistance[k] * contacts.approach_velocity[k] * contacts.approach_velocity[k];
    sliding += law.sliding_resistance[k] * contacts.sliding_velocity[k].squaredNorm();
  }
  const double total = normal + sliding;
  return total > 0.0 ? sliding / total : no_value;
}

}  // namespace frit::observe
