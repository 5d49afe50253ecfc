// The options that all subcommands with a case share: the file and what --set overrides in it.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "config/case.hpp"

namespace frit::app {

struct CaseOptions {
  std::filesystem::path file;
  std::vector<std::string> overrides;

  void add_to(CLI::App& command);
  config::Case load() const;  // throws InputError with all faults of the case
};

}  // namespace frit::app
