#include "run/result_folder.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "io/pvd.hpp"
#include "io/series.hpp"
#include "io/text.hpp"
#include "io/vtp.hpp"
#include "run/folders.hpp"
#include "run/samples.hpp"
#include "solve/dump.hpp"

namespace frit::run {
namespace {

using samples::pair_case;
using samples::periodic_case;
using samples::Recorder;

const io::NamedArray& array_named(const std::vector<io::NamedArray>& arrays, const std::string& name) {
  const auto found =
      std::find_if(arrays.begin(), arrays.end(), [&](const auto& a) { return a.name == name; });
  if (found == arrays.end()) throw std::runtime_error("no array " + name);
  return *found;
}

nlohmann::json summary_in(const std::filesystem::path& folder) {
  return nlohmann::json::parse(io::read_file_whole(folder / "summary.json"));
}

TEST(ResultFolder, TheSeriesReadsBackToTheBitsOfTheRows) {
  const io::TemporaryFolder folder;
  ResultFolder files(folder / "out");
  Recorder recorder;
  run_case(pair_case(folder, {"output.every_time=7"}), {&files, &recorder});
  const io::Series series = io::read_series(folder / "out" / "series.csv");
  ASSERT_EQ(series.columns.size(), recorder.rows.front().size());
  for (std::size_t column = 0; column < series.columns.size(); ++column) {
    const std::string& name = series.columns[column];
    const auto expected = recorder.column(name);
    ASSERT_EQ(series.values[column].size(), expected.size());
    for (std::size_t row = 0; row < expected.size(); ++row) {
      if (std::isnan(expected[row])) {
        EXPECT_TRUE(std::isnan(series.values[column][row])) << name;
      } else {
        EXPECT_EQ(series.values[column][row], expected[row]) << name;
      }
    }
  }
}

TEST(ResultFolder, TheResolvedCaseRunsToTheSameSeries) {
  const io::TemporaryFolder folder;
  ResultFolder first(folder / "first"), second(folder / "second");
  run_case(periodic_case(folder, "simple-cubic", 8, {"stop.relative_density=0.6"}), {&first});
  run_case(config::load_case(folder / "first" / "case.toml"), {&second});
  EXPECT_EQ(io::bytes_of(folder / "first" / "series.csv"), io::bytes_of(folder / "second" / "series.csv"));
  EXPECT_EQ(io::bytes_of(folder / "first" / "case.toml"), io::bytes_of(folder / "second" / "case.toml"));
}

TEST(ResultFolder, TheSummaryTellsHowTheRunWent) {
  const io::TemporaryFolder folder;
  ResultFolder files(folder / "out");
  Recorder recorder;
  run_case(pair_case(folder, {"contact.pull=unilateral", "packing.seed=4"}), {&files, &recorder});
  const auto summary = summary_in(folder / "out");
  EXPECT_EQ(summary["exit"]["code"], 0);
  EXPECT_EQ(summary["steps"], recorder.totals.steps);
  EXPECT_EQ(summary["newton_iterations"], recorder.totals.newton_iterations);
  EXPECT_EQ(summary["final"]["time [s]"], 60.0);
  EXPECT_TRUE(summary["final"]["relative_density"].is_null());
  EXPECT_EQ(summary["accuracy_asked"], 0.01);
  EXPECT_LE(summary["accuracy_estimated"].get<double>(), 0.01);
  EXPECT_EQ(summary["attraction"], "bouvard-mcmeeking");
  EXPECT_EQ(summary["pull"], "unilateral");
  EXPECT_EQ(summary["seed"], 4);
  EXPECT_EQ(summary["warnings"].size(), 1u);
  EXPECT_GT(summary["peak_memory_bytes"].get<double>(), 1e6);
  EXPECT_GE(summary["machine"]["cores"].get<int>(), 1);
  for (const std::string clock : {"wall_s", "cpu_s"}) {
    double sum = 0.0;
    for (const std::string stage : {"setup", "step", "observe", "output"})
      sum += summary[clock][stage].get<double>();
    EXPECT_NEAR(summary[clock]["total"].get<double>(), sum, 1e-9);
  }
}

TEST(ResultFolder, SnapshotsHoldParticlesAndContactsInTheOrderOfIds) {
  const io::TemporaryFolder folder;
  ResultFolder files(folder / "out");
  Recorder recorder;
  run_case(
      periodic_case(folder, "random-dense", 60, {"stop.relative_density=0.66", "output.every_density=0.01"}),
      {&files, &recorder});
  const auto entries = io::read_pvd(folder / "out" / "snapshots.pvd");
  ASSERT_EQ(entries.size(), 2 * recorder.rows.size());
  const auto particles = io::read_vtp_frame(folder / "out" / entries[entries.size() - 2].file);
  EXPECT_EQ(particles.time, recorder.last.time);
  EXPECT_TRUE(std::is_sorted(particles.ids.begin(), particles.ids.end()));
  const auto contacts = io::read_vtp(folder / "out" / entries.back().file);
  const auto& i = std::get<std::vector<std::int64_t>>(array_named(contacts.cell_arrays, "i").values);
  const auto& j = std::get<std::vector<std::int64_t>>(array_named(contacts.cell_arrays, "j").values);
  ASSERT_EQ(i.size(), recorder.last.contacts.size());
  const auto& force =
      std::get<std::vector<double>>(array_named(contacts.cell_arrays, "normal_force [N]").values);
  EXPECT_EQ(force.size(), i.size());
  for (std::size_t k = 0; k < i.size(); ++k) {
    EXPECT_LE(i[k], j[k]);
    // A contact's segment begins at the particle it names.
    EXPECT_EQ(contacts.points[2 * k], particles.positions[static_cast<std::size_t>(i[k])]);
  }
}

TEST(ResultFolder, WithoutSnapshotsOnlyTheFourFilesAreWritten) {
  const io::TemporaryFolder folder;
  ResultFolder files(folder / "out");
  run_case(pair_case(folder, {"output.snapshots=false"}), {&files});
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "out"))
    names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  EXPECT_EQ(names, (std::vector<std::string>{"case.toml", "checkpoint.cbor", "series.csv", "summary.json"}));
}

TEST(ResultFolder, AFailedStepLeavesItsProblem) {
  const io::TemporaryFolder folder;
  ResultFolder files(folder / "out");
  run_case(
      periodic_case(folder, "random-dense", 100, {"method.tolerance=1e-17", "method.smallest_step=1e-3"}),
      {&files});
  const auto bytes = io::read_file_whole(folder / "out" / "failed_problem.cbor");
  const auto dumped = solve::load_dump({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
  EXPECT_EQ(dumped.problem.bodies(), 100u);
  EXPECT_EQ(summary_in(folder / "out")["exit"]["code"], 3);
}

TEST(Folders, ResultsAreNotReplacedUnasked) {
  const io::TemporaryFolder folder;
  EXPECT_NO_THROW(check_result_folder(folder / "new", Existing::refuse));
  make_folder(folder / "out");
  EXPECT_NO_THROW(check_result_folder(folder / "out", Existing::refuse));
  folder.write("out/notes.txt", "mine");
  EXPECT_NO_THROW(check_result_folder(folder / "out", Existing::refuse));
  folder.write("out/series.csv", "");
  EXPECT_THROW(check_result_folder(folder / "out", Existing::refuse), InputError);
  EXPECT_NO_THROW(check_result_folder(folder / "out", Existing::replace));
  folder.write("file", "");
  EXPECT_THROW(check_result_folder(folder / "file", Existing::replace), InputError);
}

TEST(Folders, ReplacingRemovesResultsAndNothingElse) {
  const io::TemporaryFolder folder;
  make_folder(folder / "out/snapshots");
  const std::vector<std::string> ours{
      "out/series.csv", "out/summary.json", "out/snapshots/particles_000007.vtp",
      "out/snapshots/particles_000007.xyz", "out/snapshots/particles_000007.dump"};
  const std::vector<std::string> theirs{"out/notes.txt", "out/snapshots/mine.vtp",
                                        "out/snapshots/particles_.txt"};
  for (const auto& name : ours) folder.write(name, "");
  for (const auto& name : theirs) folder.write(name, "");
  remove_results(folder / "out");
  for (const auto& name : ours) EXPECT_FALSE(std::filesystem::exists(folder / name)) << name;
  for (const auto& name : theirs) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
}

TEST(Folders, AFolderThatCannotBeMadeIsAFaultOfTheMachine) {
  const io::TemporaryFolder folder;
  folder.write("file", "");
  EXPECT_THROW(make_folder(folder / "file/out"), MachineError);
}

}  // namespace
}  // namespace frit::run
