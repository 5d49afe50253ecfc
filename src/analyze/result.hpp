// The result of a run as its folder tells it: series, case, scales.
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "io/series.hpp"

namespace frit::analyze {

struct Result {
  std::string name;  // as the user named the folder
  io::Series series;
  std::map<std::string, std::string> keys;  // of case.toml: "contact.sliding_resistance" to its value as text
  double tau_per_theta;                     // gamma/R^4 [N s/m^5]; NaN: summary.json does not tell

  // Values of a column; nullptr where there is none.
  const std::vector<double>* column(const std::string& name) const;
};

// InputError where the folder, its series.csv or its case.toml is missing or cannot be understood.
Result read_result(const std::filesystem::path& folder);

// A key that is not the same in all results; an empty text where a case lacks it.
struct CaseDifference {
  std::string key;
  std::vector<std::string> values;  // one a result
};
std::vector<CaseDifference> case_differences(const std::vector<Result>& results);

}  // namespace frit::analyze
