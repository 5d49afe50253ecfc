#include "run/result_folder.hpp"

#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "config/case_writer.hpp"
#include "io/json.hpp"
#include "io/write_file.hpp"
#include "run/id_order.hpp"
#include "run/machine.hpp"
#include "run/summary.hpp"
#include "solve/dump.hpp"

namespace frit::run {

namespace {

namespace fs = std::filesystem;

std::vector<std::string> names_of(const observe::Row& row) {
  std::vector<std::string> names;
  for (const observe::Column& column : row) names.push_back(column.name);
  return names;
}

std::vector<double> times_of(const fs::path& series) { return io::read_series(series).values.at(0); }

}  // namespace

ResultFolder::ResultFolder(fs::path folder) : folder_(std::move(folder)) {}

ResultFolder::ResultFolder(fs::path folder, FolderLock lock, const io::SeriesExtent& kept)
    : folder_(std::move(folder)), lock_(std::move(lock)), kept_(kept) {}

void ResultFolder::started(const Setup& setup) {
  setup_ = &setup;
  make_folder(folder_);
  if (!lock_) lock_.emplace(folder_);
  if (!kept_) remove_results(folder_);
  io::write_file_whole(folder_ / "case.toml", config::write_case(setup.whole, version()));
  if (setup.whole.output.snapshots && !kept_) snapshots_.emplace(folder_, setup.whole.output.formats);
}

void ResultFolder::resumed(const ResumeView& view) {
  resumed_step_ = view.totals.steps;
  series_ = io::SeriesWriter::resume(folder_ / "series.csv", names_of(view.row), *kept_);
  remove_what_follows(folder_, kept_->rows);
  const config::Output& output = setup_->whole.output;
  if (output.snapshots) snapshots_.emplace(folder_, output.formats, times_of(folder_ / "series.csv"));
}

void ResultFolder::row_written(const RowView& view) {
  std::vector<double> values;
  for (const observe::Column& column : view.row) values.push_back(column.value);
  if (!series_) series_.emplace(folder_ / "series.csv", names_of(view.row));
  series_->write_row(values);
  if (!snapshots_) return;
  const State ordered = in_id_order(view.state);
  snapshots_->write(setup_->reference, ordered, necks_of(setup_->settings.law, ordered, view.delta_b));
}

// Rows first: a checkpoint counts on them.
void ResultFolder::checkpoint_due(const Standing& now) {
  write_checkpoint(folder_, checkpoint_bytes(*setup_, now, series_->flush_to_disk()));
}

void ResultFolder::finished(const EndView& view) {
  if (view.failed != nullptr) {
    const std::vector<std::uint8_t> bytes = solve::dump(view.failed->problem, view.failed->start);
    io::write_file_whole(folder_ / "failed_problem.cbor",
                         {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  if (view.ending.code == 0) {
    std::error_code ignored;  // it may stay: it is as good as the last one, only older
    fs::remove(folder_ / previous_checkpoint_name, ignored);
  }
  nlohmann::json summary = summary_of(*setup_, view);
  summary["resumed_at_step"] = kept_ ? nlohmann::json(resumed_step_) : nlohmann::json();
  io::write_json(folder_ / "summary.json", summary);
}

}  // namespace frit::run
