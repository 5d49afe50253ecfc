#include <fmt/core.h>

#include <memory>
#include <string>

#include "app/commands.hpp"
#include "config/materials.hpp"
#include "config/reference.hpp"

namespace frit::app {

void add_describe(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("describe", "the reference of all keys of a case, or of one");
  const auto key = std::make_shared<std::string>();
  command->add_option("KEY", *key, "a key (contact.pull) or a section (contact)");
  command->callback([key, &chosen] {
    chosen = [key] {
      fmt::print("{}", config::describe(*key));
      return 0;
    };
  });
}

void add_materials(CLI::App& app, Command& chosen) {
  CLI::App* command = app.add_subcommand("materials", "the built-in materials and their sources");
  command->callback([&chosen] {
    chosen = [] {
      fmt::print("{}", config::materials_text());
      return 0;
    };
  });
}

}  // namespace frit::app
