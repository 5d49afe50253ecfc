// How quantities are distributed over particles and contacts at each snapshot, for the report's histograms.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace frit::report {

inline constexpr std::size_t histogram_bins = 48;

// The range that all histograms of a quantity share. Widened by values, read out once.
struct ValueRange {
  double least, most;
  static ValueRange none();
  void widen(std::span<const double> values);  // what is not finite is passed over
  bool is_empty() const { return !(least <= most); }
};

// Counts in `bins` equal parts of the range; the last one holds its upper end. What is not finite or outside
// is passed over. A range without width has all its values in the first bin.
std::vector<std::int64_t> histogram(std::span<const double> values, const ValueRange& range,
                                    std::size_t bins);

// The values of one quantity at one snapshot after another.
class Distribution {
 public:
  Distribution(std::string name, std::string over) : name_(std::move(name)), over_(std::move(over)) {}

  void add(std::vector<double> values);
  bool is_empty() const { return range_.is_empty(); }
  // {"name", "over": "particles" | "contacts", "range": [least, most], "counts": [[...] a snapshot], "mean":
  // [...]}; whole numbers get bins of their own.
  nlohmann::json to_json() const;

 private:
  bool is_whole() const;

  std::string name_, over_;  // with its unit; particles or contacts
  ValueRange range_ = ValueRange::none();
  std::vector<std::vector<double>> values_;  // one list a snapshot
};

}  // namespace frit::report
