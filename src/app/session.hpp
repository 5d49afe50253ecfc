// What `frit run` and `frit resume` share: threads, display, signals, the wall-time limit, the report.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <functional>
#include <string>

#include "run/listener.hpp"
#include "run/requests.hpp"

namespace frit::app {

struct SessionOptions {
  int threads = 0;
  bool quiet = false, json = false;
  std::string max_wall;

  void add_to(CLI::App& command);
  double wall_limit() const;  // [s], infinity without one; throws InputError where it is no duration
};

using Work = std::function<run::Ending(run::RunListener& display, run::Requests requests)>;

// Does the work and returns its exit code; writes the folder's report where it is wanted.
int run_session(const SessionOptions& options, const std::filesystem::path& folder, bool wants_report,
                const Work& work);

// Seconds of "11h50m", "90 s", "2d", or a bare number. Throws InputError with what is allowed.
double parse_wall_time(const std::string& text);

}  // namespace frit::app
