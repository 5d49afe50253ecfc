// Runs side by side: the same figures at equal density, or at equal dimensionless time.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "analyze/result.hpp"

namespace frit::analyze {

enum class Equal { density, time };  // what is equal: relative_density, or tau = theta gamma/R^4

// Values that grow with time as tau do, while shrinkage grows with its cube root (x^6 = 54 tau): the roots
// are what is interpolated.
enum class Course { plain, time_like };

// The abscissa of a result: its rows where it is above all rows before, so that each value is met once, when
// it was first reached.
struct Abscissa {
  std::vector<std::size_t> rows;  // of the series
  std::vector<double> values;     // one a row, ascending
  Course course = Course::plain;
};
Abscissa abscissa_of(const Result& result, Equal equal);

// A column where the abscissa is `at`, by interpolate_monotone over its rows; NaN outside or next to an empty
// cell. A time-like abscissa is taken by its cube root too.
double value_at(const Abscissa& abscissa, const std::vector<double>& column, Course course, double at);

// A quantity of all results.
struct Figure {
  std::string column;                       // of series.csv, or "tau"
  std::vector<std::vector<double>> values;  // [result][point]
};

struct Comparison {
  Equal equal = Equal::density;
  std::vector<std::string> names;                 // of the results
  std::vector<std::pair<double, double>> ranges;  // of each result's abscissa; NaN: it has none
  std::vector<double> points;   // ascending, within all ranges; empty: they have nothing in common
  std::vector<Figure> figures;  // all columns that every result has
  std::vector<CaseDifference> differences;
};

// At the ends of the common range and at round values between. InputError for equal time where a result does
// not tell its scales.
Comparison compare(const std::vector<Result>& results, Equal equal);

// Difference to the first result in percent of it.
double percent(const Figure& figure, std::size_t result, std::size_t point);

// Dimensionless time of each row; NaN where it is not known.
std::vector<double> tau_of(const Result& result);

}  // namespace frit::analyze
