// The observables of a state as the columns of series.csv, in their order. Reference: docs/observables.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "observe/necks.hpp"
#include "observe/reference.hpp"
#include "state/state.hpp"

namespace frit::observe {

struct Column {
  std::string name;  // with the unit in brackets, if it has one
  double value;      // NaN: no value, an empty field
};
using Row = std::vector<Column>;

// The names and their order are the same for every state.
Row observe_row(const Reference& reference, const State& state, const NeckLaw& law);

struct Unit {
  std::string_view text;  // with a leading blank and brackets, or empty
};

// Appends the columns name_mean, name_q10, name_q50, name_q90.
void add_distribution(Row& row, const std::string& name, const Distribution& values, Unit unit = {});

// The value of the column with that name, unit included. Throws ContractError when there is none.
double value_of(const Row& row, std::string_view name);

}  // namespace frit::observe
