// A run's files: case.toml, series.csv, snapshots, and at the end summary.json (docs/formats.md).
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>

#include "io/series.hpp"
#include "run/folders.hpp"
#include "run/listener.hpp"
#include "run/snapshots.hpp"

namespace frit::run {

class ResultFolder : public RunListener {
 public:
  // The folder is made, and earlier results in it removed, when the run starts; nothing is touched before.
  explicit ResultFolder(std::filesystem::path folder);

  // Goes on with a run after these rows; what follows them is removed when the run starts.
  ResultFolder(std::filesystem::path folder, FolderLock lock, const io::SeriesExtent& kept);

  // Each throws MachineError where a file cannot be written.
  void started(const Setup& setup) override;
  void resumed(const ResumeView& view) override;
  void row_written(const RowView& view) override;
  void checkpoint_due(const Standing& now) override;
  void finished(const EndView& view) override;

 private:
  std::filesystem::path folder_;
  std::optional<FolderLock> lock_;
  std::optional<io::SeriesExtent> kept_;  // of a run that goes on
  std::int64_t resumed_step_ = 0;
  const Setup* setup_ = nullptr;
  std::optional<io::SeriesWriter> series_;
  std::optional<SnapshotWriter> snapshots_;
};

}  // namespace frit::run
