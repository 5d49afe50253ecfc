#include "analyze/comparison.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "analyze/monotone.hpp"
#include "core/error.hpp"
#include "observe/statistics.hpp"

namespace frit::analyze {
namespace {

using observe::no_value;

constexpr std::size_t most_round_points = 9;

// The largest of 1, 2, 5 times a power of ten that puts at most nine multiples between low and high.
double round_step(double low, double high) {
  double power =
      std::pow(10.0, std::floor(std::log10((high - low) / static_cast<double>(most_round_points))));
  for (;; power *= 10.0) {
    for (const double factor : {1.0, 2.0, 5.0}) {
      const double step = factor * power;
      if (std::floor(high / step) - std::ceil(low / step) + 1.0 <= static_cast<double>(most_round_points))
        return step;
    }
  }
}

std::vector<double> points_between(double low, double high) {
  if (!(low <= high)) return {};
  std::vector<double> points{low};
  if (low == high) return points;
  const double step = round_step(low, high), clearance = 0.1 * step;
  for (double n = std::ceil(low / step); n * step < high; n += 1.0) {
    if (n * step > low + clearance && n * step < high - clearance) points.push_back(n * step);
  }
  points.push_back(high);
  return points;
}

// Sintering slows down without end: 1, 2, 5 times powers of ten, the last nine before `high`, and `high`.
std::vector<double> times_between(double low, double high) {
  if (!(low <= high) || !(high > 0.0)) return {};
  std::vector<double> points{high};
  for (double power = std::pow(10.0, std::floor(std::log10(high))); points.size() <= most_round_points;
       power /= 10.0) {
    for (const double factor : {5.0, 2.0, 1.0}) {
      const double point = factor * power;
      if (point <= low) return points;
      if (point < 0.95 * high && points.size() <= most_round_points) points.insert(points.begin(), point);
    }
  }
  return points;
}

void check_scales(const std::vector<Result>& results) {
  std::vector<std::string> faults;
  for (const Result& result : results) {
    if (!std::isnan(result.tau_per_theta)) continue;
    faults.push_back(
        fmt::format("{}: summary.json does not tell mean_radius_m and surface_energy_J_per_m2, which equal "
                    "time needs; allowed: --at density, or a run by this version",
                    result.name));
  }
  if (!faults.empty()) throw InputError(faults);
}

Course course_of(const std::string& column) {
  const bool is_time = column == "tau" || column.starts_with("time [") || column.starts_with("theta [");
  return is_time ? Course::time_like : Course::plain;
}

// Columns that all results have, in the order of the first.
std::vector<std::string> common_columns(const std::vector<Result>& results) {
  std::vector<std::string> columns;
  for (const std::string& name : results.front().series.columns) {
    if (std::ranges::all_of(results, [&](const Result& result) { return result.column(name) != nullptr; }))
      columns.push_back(name);
  }
  return columns;
}

template <class Values>
Figure figure_of(const std::string& name, const Comparison& comparison,
                 const std::vector<Abscissa>& abscissas, Values&& values_of) {
  Figure figure{name, {}};
  for (std::size_t n = 0; n < abscissas.size(); ++n) {
    const std::vector<double> column = values_of(n);
    std::vector<double> values;
    for (const double at : comparison.points)
      values.push_back(value_at(abscissas[n], column, course_of(name), at));
    figure.values.push_back(std::move(values));
  }
  return figure;
}

}  // namespace

std::vector<double> tau_of(const Result& result) {
  const std::vector<double>* theta = result.column("theta [m^5 s/(N s)]");
  std::vector<double> tau =
      theta != nullptr ? *theta : std::vector<double>(result.series.values.front().size(), no_value);
  for (double& value : tau) value *= result.tau_per_theta;
  return tau;
}

Abscissa abscissa_of(const Result& result, Equal equal) {
  const std::vector<double>* density = result.column("relative_density");
  const std::vector<double> values = equal == Equal::time ? tau_of(result)
                                     : density != nullptr ? *density
                                                          : std::vector<double>{};
  Abscissa abscissa{{}, {}, equal == Equal::time ? Course::time_like : Course::plain};
  double highest = -std::numeric_limits<double>::infinity();
  for (std::size_t row = 0; row < values.size(); ++row) {
    if (!(values[row] > highest)) continue;
    highest = values[row];
    abscissa.rows.push_back(row);
    abscissa.values.push_back(highest);
  }
  return abscissa;
}

double value_at(const Abscissa& abscissa, const std::vector<double>& column, Course course, double at) {
  std::vector<double> x = abscissa.values, y;
  for (const std::size_t row : abscissa.rows) y.push_back(column[row]);
  if (const auto found = std::ranges::find(x, at); found != x.end()) return y[found - x.begin()];
  const auto take_roots = [](std::vector<double>& values) {
    std::ranges::transform(values, values.begin(), [](double value) { return std::cbrt(value); });
  };
  if (abscissa.course == Course::time_like) {
    take_roots(x);
    at = std::cbrt(at);
  }
  if (course == Course::plain) return interpolate_monotone(x, y, at);
  take_roots(y);
  const double root = interpolate_monotone(x, y, at);
  return root * root * root;
}

Comparison compare(const std::vector<Result>& results, Equal equal) {
  if (equal == Equal::time) check_scales(results);
  Comparison comparison;
  comparison.equal = equal;
  comparison.differences = case_differences(results);
  std::vector<Abscissa> abscissas;
  double low = -std::numeric_limits<double>::infinity(), high = std::numeric_limits<double>::infinity();
  for (const Result& result : results) {
    comparison.names.push_back(result.name);
    abscissas.push_back(abscissa_of(result, equal));
    const std::vector<double>& values = abscissas.back().values;
    comparison.ranges.push_back(values.empty() ? std::pair(no_value, no_value)
                                               : std::pair(values.front(), values.back()));
    low = values.empty() ? std::numeric_limits<double>::infinity() : std::max(low, values.front());
    high = values.empty() ? high : std::min(high, values.back());
  }
  comparison.points = equal == Equal::time ? times_between(low, high) : points_between(low, high);
  comparison.figures.push_back(
      figure_of("tau", comparison, abscissas, [&](std::size_t n) { return tau_of(results[n]); }));
  for (const std::string& name : common_columns(results)) {
    comparison.figures.push_back(
        figure_of(name, comparison, abscissas, [&](std::size_t n) { return *results[n].column(name); }));
  }
  return comparison;
}

double percent(const Figure& figure, std::size_t result, std::size_t point) {
  const double first = figure.values.front()[point];
  return 100.0 * (figure.values[result][point] - first) / std::abs(first);
}

}  // namespace frit::analyze
