// Collects the faults of a file so that the user sees them together, but not thousands of them.
#pragma once

#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"

namespace frit::io {

class FaultList {
 public:
  static constexpr std::size_t most_shown = 20;

  void add(std::string fault) {
    if (faults_.size() < most_shown) {
      faults_.push_back(std::move(fault));
    } else {
      ++hidden_;
    }
  }

  bool empty() const { return faults_.empty(); }

  // Throws InputError with the first faults and, if there were more, their number.
  void throw_if_any() const {
    if (faults_.empty()) return;
    auto shown = faults_;
    if (hidden_ > 0) shown.push_back("and " + std::to_string(hidden_) + " more");
    throw InputError(std::move(shown));
  }

 private:
  std::vector<std::string> faults_;
  std::size_t hidden_ = 0;
};

}  // namespace frit::io
