// The machine and the program a run is made with, for its summary.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace frit::run {

std::string_view version();

struct Machine {
  std::string cpu;  // model name; "unknown" where the system does not tell
  int cores = 0;    // that this process may use
};
Machine this_machine();

std::int64_t peak_memory_bytes();

}  // namespace frit::run
