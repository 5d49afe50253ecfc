// The program `frit`: reads the command line, runs a subcommand, turns what went wrong into an exit code.
#include <fmt/core.h>

#include <malloc.h>

#include <csignal>
#include <cstdio>
#include <exception>
#include <new>
#include <string>
#include <system_error>

#include "app/commands.hpp"
#include "core/error.hpp"
#include "run/machine.hpp"

namespace {

enum ExitCode { done = 0, machine_failed = 1, wrong_input = 2, own_check_failed = 5 };

int tell(const std::string& text, ExitCode code) {
  fmt::print(stderr, "frit: {}\n", text);
  return code;
}

int tell_faults(const frit::InputError& error) {
  for (const std::string& fault : error.faults()) fmt::print(stderr, "frit: {}\n", fault);
  return wrong_input;
}

// What is wrong with the command line, in the words of one who typed it.
std::string fault_of(const CLI::App& app, int argc, char** argv, const CLI::ParseError& error) {
  const auto used = app.get_subcommands();
  if (used.empty()) {
    std::string names;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; }))
      names += (names.empty() ? "" : ", ") + command->get_name();
    return fmt::format("{}; allowed: {}",
                       argc > 1 ? fmt::format("'{}' is no command", argv[1]) : "a command is missing", names);
  }
  const std::string command = used.front()->get_name();
  std::string what = error.what();
  if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr) {
    what = "not expected:";
    for (const std::string& word : used.front()->remaining()) what += " " + word;
  }
  return fmt::format("{}: {}; frit {} --help tells what is", command, what, command);
}

int run_command(CLI::App& app, int argc, char** argv, frit::app::Command& chosen) {
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) return app.exit(error);  // --help, --version
    return tell(fault_of(app, argc, argv, error), wrong_input);
  }
  return chosen();
}

// Every step takes arrays of hundreds of megabytes and gives them back. Without this the system would take
// the pages and clear new ones each time: an eighth of the time of a million spheres.
void keep_freed_memory() {
#ifdef __GLIBC__
  constexpr int largest_kept = 1 << 30;
  mallopt(M_MMAP_THRESHOLD, largest_kept);
  mallopt(M_TRIM_THRESHOLD, largest_kept);
#endif
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  // A full disk or a closed pipe is told as an error of that write, not by ending the program.
  std::signal(SIGPIPE, SIG_IGN);
  std::signal(SIGXFSZ, SIG_IGN);
  CLI::App app("frit simulates how powders sinter, by non-smooth contact dynamics", "frit");
  app.set_version_flag("--version", "frit " + std::string(frit::run::version()));
  app.require_subcommand(1);
  frit::app::Command chosen;
  for (const auto add :
       {frit::app::add_run, frit::app::add_check, frit::app::add_describe, frit::app::add_materials,
        frit::app::add_pack, frit::app::add_convert, frit::app::add_replay, frit::app::add_analyze,
        frit::app::add_compare, frit::app::add_report, frit::app::add_resume}) {
    add(app, chosen);
  }
  try {
    const int code = run_command(app, argc, argv, chosen);
    if (std::fflush(stdout) == 0) return code;
    return tell("standard output: writing failed; check the disk or the program that reads it",
                machine_failed);
  } catch (const frit::InputError& error) {
    return tell_faults(error);
  } catch (const frit::MachineError& error) {
    return tell(error.what(), machine_failed);
  } catch (const std::system_error& error) {
    return tell(std::string("the system failed: ") + error.what(), machine_failed);
  } catch (const std::bad_alloc&) {
    return tell("there is not enough memory; use fewer particles or another machine", machine_failed);
  } catch (const frit::ContractError& error) {
    return tell(std::string("a check of the program itself failed, please report it: ") + error.what(),
                own_check_failed);
  } catch (const std::exception& error) {
    return tell(std::string("an error nobody foresaw, please report it: ") + error.what(), own_check_failed);
  }
}
