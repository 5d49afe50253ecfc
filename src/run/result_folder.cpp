#include "run/result_folder.hpp"

#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "config/case_writer.hpp"
#include "io/json.hpp"
#include "io/write_file.hpp"
#include "run/folders.hpp"
#include "run/id_order.hpp"
#include "run/machine.hpp"
#include "run/summary.hpp"
#include "solve/dump.hpp"

namespace frit::run {

ResultFolder::ResultFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

void ResultFolder::started(const Setup& setup) {
  setup_ = &setup;
  make_folder(folder_);
  remove_results(folder_);
  io::write_file_whole(folder_ / "case.toml", config::write_case(setup.whole, version()));
  if (setup.whole.output.snapshots) snapshots_.emplace(folder_);
}

void ResultFolder::row_written(const RowView& view) {
  std::vector<double> values;
  std::vector<std::string> columns;
  for (const observe::Column& column : view.row) {
    columns.push_back(column.name);
    values.push_back(column.value);
  }
  if (!series_) series_.emplace(folder_ / "series.csv", columns);
  series_->write_row(values);
  if (!snapshots_) return;
  const State ordered = in_id_order(view.state);
  snapshots_->write(setup_->reference, ordered, necks_of(setup_->settings.law, ordered, view.delta_b));
}

void ResultFolder::finished(const EndView& view) {
  if (view.failed != nullptr) {
    const std::vector<std::uint8_t> bytes = solve::dump(view.failed->problem, view.failed->start);
    io::write_file_whole(folder_ / "failed_problem.cbor",
                         {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  }
  io::write_json(folder_ / "summary.json", summary_of(*setup_, view));
}

}  // namespace frit::run
