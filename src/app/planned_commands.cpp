#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "app/commands.hpp"
#include "core/error.hpp"

namespace frit::app {

void add_planned(CLI::App& app, Command& chosen) {
  constexpr std::array<std::pair<const char*, const char*>, 1> planned{{
      {"resume", "goes on from the last checkpoint"},
  }};
  for (const auto& [name, purpose] : planned) {
    CLI::App* command = app.add_subcommand(name, std::string(purpose) + " (not available yet)");
    command->prefix_command();
    command->callback([name = std::string(name), &chosen] {
      chosen = [name]() -> int { throw InputError(name + ": not available yet in this version"); };
    });
  }
}

}  // namespace frit::app
