#include "app/case_options.hpp"

#include "config/case_reader.hpp"

namespace frit::app {

void CaseOptions::add_to(CLI::App& command) {
  command.add_option("CASE", file, "case file (TOML)")->required();
  command
      .add_option("--set", overrides,
                  "replaces one key of the case, e.g. --set stop.time=2h; may be repeated")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
}

config::Case CaseOptions::load() const { return config::load_case(file, overrides); }

}  // namespace frit::app
