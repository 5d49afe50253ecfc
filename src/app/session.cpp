#include "app/session.hpp"

#include <fmt/core.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <limits>
#include <optional>
#include <string_view>
#include <system_error>

#include "app/interrupts.hpp"
#include "app/progress.hpp"
#include "core/abandoned.hpp"
#include "core/error.hpp"
#include "core/parallel.hpp"
#include "report/page.hpp"

namespace frit::app {
namespace {

using Clock = std::chrono::steady_clock;

// The program's start: its static objects are made before main.
const Clock::time_point program_start = Clock::now();

Display display_of(const SessionOptions& options) {
  if (options.json) return Display::json;
  if (options.quiet) return Display::quiet;
  return ::isatty(STDOUT_FILENO) != 0 ? Display::bar : Display::lines;
}

// A page that is missing from this build does not spoil the run.
void write_report(const std::filesystem::path& folder, const SessionOptions& options) {
  if (!report::has_page()) {
    if (!options.quiet) fmt::print(stderr, "frit: no report.html: {}\n", report::page_missing_text);
    return;
  }
  report::write_page(std::array{folder}, folder / "report.html");
}

// The next number and its unit, taken off `text`; seconds without a unit.
std::optional<double> take_part(std::string_view& text) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{} || !std::isfinite(number) || number < 0.0) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  const char unit = text.empty() ? 's' : text.front();
  if (!text.empty()) text.remove_prefix(1);
  text.remove_prefix(std::min(text.find_first_not_of(' '), text.size()));
  switch (unit) {
    case 'd':
      return 86400.0 * number;
    case 'h':
      return 3600.0 * number;
    case 'm':
      return 60.0 * number;
    case 's':
      return number;
    default:
      return std::nullopt;
  }
}

// Before its first row a run has no folder.
int tell_abandoned(const std::string& why) {
  const int signal = interrupt_received();
  const std::string by = signal != 0 ? fmt::format("signal {}", signal) : "--max-wall";
  fmt::print(stderr, "frit: stopped by {} before the first step: {}; nothing is written\n", by, why);
  return signal != 0 ? 128 + signal : 4;
}

}  // namespace

double parse_wall_time(const std::string& text) {
  std::string_view rest = text;
  double seconds = 0.0;
  bool is_duration = !text.empty();
  while (is_duration && !rest.empty()) {
    const auto part = take_part(rest);
    is_duration = part.has_value();
    seconds += part.value_or(0.0);
  }
  if (is_duration && seconds > 0.0) return seconds;
  throw InputError(fmt::format(
      "--max-wall: '{}' is no duration; allowed: days, hours, minutes and seconds, e.g. 11h50m, 90s, 1d12h",
      text.substr(0, 80)));
}

void SessionOptions::add_to(CLI::App& command) {
  command.add_option("--threads", threads, "threads to use; default: every processor")
      ->check(CLI::Range(1, 4096));
  command.add_option("--max-wall", max_wall,
                     "end before this wall time, e.g. 11h50m, with a checkpoint to go on from (exit code 4)");
  command.add_flag("--quiet", quiet, "nothing but errors on the terminal");
  command.add_flag("--json", json, "progress as one JSON object per line");
}

double SessionOptions::wall_limit() const {
  return max_wall.empty() ? std::numeric_limits<double>::infinity() : parse_wall_time(max_wall);
}

int run_session(const SessionOptions& options, const std::filesystem::path& folder, bool wants_report,
                const Work& work) {
  set_threads(options.threads);
  catch_interrupts();
  const auto display = make_display(display_of(options));
  const auto seconds = [] { return std::chrono::duration<double>(Clock::now() - program_start).count(); };
  try {
    const run::Ending ending = work(*display, {.interrupt = interrupt_received,
                                               .asks_checkpoint = checkpoint_asked,
                                               .wall_seconds = seconds,
                                               .wall_limit = options.wall_limit()});
    if (ending.code == 3) fmt::print(stderr, "frit: {}\n", ending.reason);
    if (wants_report) write_report(folder, options);
    return ending.code;
  } catch (const Abandoned& error) {
    return tell_abandoned(error.what());
  }
}

}  // namespace frit::app
