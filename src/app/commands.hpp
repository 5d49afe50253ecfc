// The subcommands of the program: each reads its options from the command line and returns an exit code.
#pragma once

#include <CLI/CLI.hpp>
#include <functional>

namespace frit::app {

// Work to do once the command line has been read; its result is the exit code. What it throws is told on the
// terminal by main.
using Command = std::function<int()>;

// Each adds its subcommand; where the user chose it, `chosen` is set to its work.
void add_run(CLI::App& app, Command& chosen);
void add_check(CLI::App& app, Command& chosen);
void add_describe(CLI::App& app, Command& chosen);
void add_materials(CLI::App& app, Command& chosen);
void add_pack(CLI::App& app, Command& chosen);
void add_convert(CLI::App& app, Command& chosen);
void add_replay(CLI::App& app, Command& chosen);
void add_analyze(CLI::App& app, Command& chosen);
void add_compare(CLI::App& app, Command& chosen);
void add_report(CLI::App& app, Command& chosen);
void add_resume(CLI::App& app, Command& chosen);

}  // namespace frit::app
