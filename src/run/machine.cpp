#include "run/machine.hpp"

#include <sched.h>

#include <fstream>
#include <string>

namespace frit::run {
namespace {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (!line.starts_with("model name")) continue;
    const auto colon = line.find(": ");
    if (colon != line.npos) return line.substr(colon + 2);
  }
  return "unknown";
}

int usable_cores() {
  cpu_set_t set;
  CPU_ZERO(&set);
  return ::sched_getaffinity(0, sizeof(set), &set) == 0 ? CPU_COUNT(&set) : 0;
}

}  // namespace

std::string_view version() { return FRIT_VERSION; }

Machine this_machine() { return {cpu_model(), usable_cores()}; }

// From /proc, because the figure of getrusage starts with the size of the process that started this one.
std::int64_t peak_memory_bytes() {
  std::ifstream status("/proc/self/status");
  std::string line;
  while (std::getline(status, line)) {
    if (line.starts_with("VmHWM:")) return 1024 * std::stoll(line.substr(6));  // in KiB
  }
  return 0;
}

}  // namespace frit::run
