#include "io/series.hpp"

#include <cmath>
#include <limits>

#include "temporary_folder.hpp"

namespace frit::io {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
const std::vector<std::string> columns{"time [s]", "relative_density", "steps"};

TEST(Series, RowsAreThereAsSoonAsTheyAreWritten) {
  const TemporaryFolder folder;
  SeriesWriter writer(folder / "series.csv", columns);
  EXPECT_EQ(bytes_of(folder / "series.csv"), "time [s],relative_density,steps\n");
  writer.write_row(std::vector{0.0, 0.64, 1.0});
  writer.write_row(std::vector{0.1, nan, 1e100});
  EXPECT_EQ(bytes_of(folder / "series.csv"), "time [s],relative_density,steps\n0,0.64,1\n0.1,,1e+100\n");
}

TEST(Series, ReadBackGivesTheSameBitsAndEmptyCellsAreNaN) {
  const TemporaryFolder folder;
  SeriesWriter writer(folder / "series.csv", columns);
  std::vector<double> times;
  for (int row = 1; row < 100; ++row) {
    times.push_back(1.0 / row);
    writer.write_row(std::vector{times.back(), nan, -0.0});
  }
  const auto series = read_series(folder / "series.csv");
  EXPECT_EQ(series.columns, columns);
  EXPECT_TRUE(same_bits(series.values[0], times));
  EXPECT_TRUE(std::isnan(series.values[1][5]));
  EXPECT_TRUE(std::signbit(series.values[2][5]));
}

TEST(Series, GoingOnGivesTheSameBytesAsNeverStopping) {
  const TemporaryFolder folder;
  const auto row = [](int k) { return std::vector{k / 3.0, nan, 1.0 * k}; };
  SeriesWriter straight(folder / "a.csv", columns);
  for (int k = 0; k < 6; ++k) straight.write_row(row(k));
  SeriesExtent kept;
  {
    SeriesWriter first(folder / "b.csv", columns);
    for (int k = 0; k < 3; ++k) first.write_row(row(k));
    kept = first.flush_to_disk();
    for (int k = 3; k < 5; ++k) first.write_row(row(k));
  }
  EXPECT_EQ(kept.rows, 3);
  std::ofstream(folder / "b.csv", std::ios::app) << "1.66,to";
  auto second = SeriesWriter::resume(folder / "b.csv", columns, kept);
  for (int k = 3; k < 6; ++k) second.write_row(row(k));
  const SeriesExtent end = second.flush_to_disk();
  EXPECT_EQ(end.rows, 6);
  EXPECT_EQ(end.checksum, straight.flush_to_disk().checksum);
  EXPECT_EQ(bytes_of(folder / "b.csv"), bytes_of(folder / "a.csv"));
}

TEST(Series, ChangedFilesAreNotContinued) {
  const TemporaryFolder folder;
  const auto path = folder.write("s.csv", "time [s],relative_density,steps\n0,1,2\n");
  EXPECT_EQ(faults_of(path,
                      [&] {
                        SeriesWriter::resume(path, columns, {2, 50, 0});
                      })
                .at(0),
            "s.csv: 2 rows are needed to go on, but only 1 are there; has the file been changed since?");
  EXPECT_EQ(
      faults_of(path,
                [&] {
                  SeriesWriter::resume(path, columns, {1, 38, 1234});
                })
          .at(0),
      "s.csv: 1 rows are needed to go on, but they are not those of this run; has the file been changed "
      "since?");
  const std::vector<std::string> others{"time [s]"};
  EXPECT_EQ(faults_of(path,
                      [&] {
                        SeriesWriter::resume(path, others, {1, 38, 0});
                      })
                .at(0),
            "s.csv:1: the header is not that of this run; has the file been changed?");
  EXPECT_EQ(bytes_of(path), "time [s],relative_density,steps\n0,1,2\n");
}

TEST(Series, FullDiskIsAMachineErrorThatNamesTheFile) {
  EXPECT_EQ(message_of<MachineError>([] { SeriesWriter("/dev/full", columns); }),
            "/dev/full: writing 32 bytes failed: No space left on device; "
            "free some disk space or write to another disk");
}

TEST(Series, MissingFolderIsAMachineErrorThatNamesTheFile) {
  EXPECT_EQ(message_of<MachineError>([] { SeriesWriter("no/such/series.csv", columns); }),
            "no/such/series.csv: opening the series for writing failed: No such file or directory; "
            "create the folder 'no/such' first");
}

TEST(Series, WrongCellsAreFaultsWithTheirLine) {
  const TemporaryFolder folder;
  const auto path = folder.write("s.csv", "a,b [s]\n1,x\n1\n");
  EXPECT_EQ(faults_of(path, [&] { read_series(path); }),
            (std::vector<std::string>{"s.csv:2: column 'b': 'x' is not a number",
                                      "s.csv:3: 1 cells, but the header has 2 columns"}));
}

}  // namespace
}  // namespace frit::io
