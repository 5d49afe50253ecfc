// Cases and helpers that the tests of config share.
#pragma once

#include <string>
#include <vector>

#include "config/case_reader.hpp"
#include "core/error.hpp"

namespace frit::config {

// The least that makes a case.
inline const std::string least_case =
    "[packing]\n"
    "generate = \"random-dense\"\n"
    "[material]\n"
    "use = \"copper\"\n"
    "[stop]\n"
    "time = \"2 h\"\n";

// Every fault of a case, or none.
inline std::vector<std::string> faults_of(const std::string& text,
                                          const std::vector<std::string>& overrides = {}) {
  try {
    parse_case(text, "case.toml", overrides);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

inline std::string all_of(const std::vector<std::string>& faults) {
  std::string text;
  for (const auto& fault : faults) text += fault + "\n";
  return text;
}

}  // namespace frit::config
