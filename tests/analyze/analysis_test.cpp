// What is analysed from the snapshots of a run is what the run wrote.
#include "analyze/analysis.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analyze/snapshots.hpp"
#include "io/frame_files.hpp"
#include "io/series.hpp"
#include "io/text.hpp"
#include "io/vtp.hpp"
#include "run/result_folder.hpp"
#include "run/samples.hpp"

namespace frit::analyze {
namespace {

using run::samples::mentions;
using run::samples::read_case;

// A small random packing, free or periodic, sintered a little.
void sinter(const io::TemporaryFolder& folder, const char* kind,
            const std::vector<std::string>& overrides = {}) {
  run::ResultFolder files(folder / "out");
  run::run_case(
      read_case(folder,
                fmt::format("[packing]\ngenerate = \"random-dense\"\ncount = 300\nradius_spread = 0.1\n"
                            "[cell]\nkind = \"{}\"\n[material]\nuse = \"copper\"\n[contact]\n"
                            "sliding_resistance = 0.001\n[stop]\nrelative_density = 0.7\n",
                            kind),
                overrides),
      {&files});
}

std::vector<std::string> faults_of(const std::function<void()>& work) {
  try {
    work();
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

class AnalysedRun : public testing::TestWithParam<const char*> {};

TEST_P(AnalysedRun, GivesTheFiguresOfTheSeries) {
  const io::TemporaryFolder folder;
  sinter(folder, GetParam());
  const io::Series series = io::read_series(folder / "out" / "series.csv");
  const auto findings = analyze_result(folder / "out", "");
  ASSERT_EQ(findings.size(), series.values.front().size());
  ASSERT_GE(findings.size(), 5U);
  ASSERT_EQ(findings.front().row.size(), series.columns.size());
  int known = 0;
  for (std::size_t column = 0; column < series.columns.size(); ++column) {
    for (std::size_t row = 0; row < findings.size(); ++row) {
      const observe::Column& found = findings[row].row[column];
      const double written = series.values[column][row];
      ASSERT_EQ(found.name, series.columns[column]);
      if (column + 4 >= series.columns.size()) {
        EXPECT_TRUE(std::isnan(found.value)) << found.name;  // of the run itself
        continue;
      }
      EXPECT_EQ(std::isnan(found.value), std::isnan(written)) << found.name << " in row " << row;
      if (std::isnan(written)) continue;
      // Sums run in another order, and strains are logarithms of ratios.
      EXPECT_NEAR(found.value, written, 1e-11 * std::abs(written) + 1e-15) << found.name << " in row " << row;
      ++known;
    }
  }
  EXPECT_GT(known, 50 * static_cast<int>(findings.size() - 1));
}

INSTANTIATE_TEST_SUITE_P(Of, AnalysedRun, testing::Values("free", "periodic"),
                         [](const auto& which) { return std::string(which.param); });

// The forces of the necks balance the stress on the cell; steps are short, since forces belong to their
// middle.
TEST(Network, CarriesTheStressOnTheCell) {
  const io::TemporaryFolder folder;
  sinter(folder, "periodic",
         {"cell.stress=[\"-2 MPa\", \"-1 MPa\", \"0 Pa\"]", "method.accuracy=1e-3", "packing.count=100",
          "stop.relative_density=0.66"});
  const auto findings = analyze_result(folder / "out", "");
  const auto stress = [&](const char* name) { return observe::value_of(findings.back().network, name); };
  EXPECT_NEAR(stress("mean_stress_xx [Pa]"), -2e6, 0.01 * 2e6);
  EXPECT_NEAR(stress("mean_stress_yy [Pa]"), -1e6, 0.01 * 2e6);
  EXPECT_NEAR(stress("mean_stress_zz [Pa]"), 0.0, 0.01 * 2e6);
}

TEST(Reference, OfAnotherSnapshotStartsTheMotionThere) {
  const io::TemporaryFolder folder;
  sinter(folder, "periodic");
  const auto from_start = analyze_result(folder / "out", ""),
             from_second = analyze_result(folder / "out", "2");
  const auto value = [](const Findings& found, const char* name) {
    return observe::value_of(found.row, name);
  };
  for (const char* name : {"rearrangement_deviation_mean", "rearrangement_d2min_q90", "contacts_gained_mean",
                           "rotation_mean [rad]", "linear_strain_x"}) {
    EXPECT_NE(value(from_start[2], name), 0.0) << name;
    EXPECT_NEAR(value(from_second[2], name), 0.0, 1e-13) << name;
  }
  for (std::size_t n = 0; n < from_start.size(); ++n) {
    EXPECT_EQ(value(from_second[n], "relative_density"), value(from_start[n], "relative_density"));
    EXPECT_NEAR(value(from_second[n], "linear_strain_y"),
                value(from_start[n], "linear_strain_y") - value(from_start[2], "linear_strain_y"), 1e-13);
  }
}

TEST(Reference, OfAFileIsThatOfItsSnapshot) {
  const io::TemporaryFolder folder;
  sinter(folder, "periodic");
  const auto path = folder / "out" / "snapshots" / "particles_000002.vtp";
  const auto by_number = analyze_result(folder / "out", "2"),
             by_file = analyze_result(folder / "out", path.string());
  // The same positions moved by whole cells, in a file that knows no contacts: spheres that overlap.
  io::Frame frame = io::read_frame(path);
  for (std::size_t n = 0; n < frame.size(); ++n)
    frame.positions[n] += (static_cast<double>(n % 3) - 1.0) * frame.cell.size;
  io::write_frame(folder / "wrapped.xyz", frame);
  const auto wrapped = analyze_result(folder / "out", (folder / "wrapped.xyz").string());
  for (std::size_t n = 0; n < by_number.size(); ++n) {
    for (std::size_t column = 0; column + 4 < by_number[n].row.size(); ++column) {
      const auto& [name, expected] = by_number[n].row[column];
      if (std::isnan(expected)) continue;
      EXPECT_EQ(by_file[n].row[column].value, expected) << name;
      if (name.starts_with("rearrangement_dev")) {
        EXPECT_NEAR(wrapped[n].row[column].value, expected, 1e-9 * expected + 1e-12) << name;
      }
    }
  }
}

TEST(Reference, ThatDoesNotFitIsTold) {
  const io::TemporaryFolder folder;
  sinter(folder, "periodic", {"packing.count=60", "stop.relative_density=0.66"});
  folder.write("other.csv", "id,x,y,z,radius\n0,0,0,0,5e-6\n99,1e-5,0,0,5e-6\n");
  const auto with = [&](const std::string& reference) {
    return faults_of([&] { analyze_result(folder / "out", reference); });
  };
  EXPECT_TRUE(mentions(with("99"), {"--reference", "no snapshot 99", "0 to"}));
  EXPECT_TRUE(mentions(with((folder / "other.csv").string()),
                       {"other.csv", "lacks 59 of the 60", "1, 2, 3, 4, 5, ..."}));
  EXPECT_TRUE(
      mentions(with((folder / "other.csv").string()), {"particles_000000.vtp", "lacks 1 of the 2", "99"}));
  EXPECT_TRUE(mentions(with("nowhere.csv"), {"nowhere.csv"}));
  io::Frame frame = io::read_frame(folder / "out" / "snapshots" / "particles_000000.vtp");
  io::write_frame(folder / "start.csv", frame);
  EXPECT_TRUE(mentions(with((folder / "start.csv").string()), {"start.csv", "has no cell", ".xyz"}));
}

TEST(Snapshots, OfADamagedResultAreFaults) {
  const io::TemporaryFolder folder;
  const auto list = [&] { list_snapshots(folder / "out"); };
  EXPECT_TRUE(mentions(faults_of(list), {"out", "no such folder"}));
  sinter(folder, "periodic", {"packing.count=60", "stop.time=1"});
  std::filesystem::remove(folder / "out" / "snapshots" / "contacts_000001.vtp");
  EXPECT_TRUE(mentions(faults_of([&] { analyze_result(folder / "out", ""); }), {"contacts_000001.vtp"}));
  std::filesystem::remove(folder / "out" / "snapshots.pvd");
  EXPECT_TRUE(mentions(faults_of(list), {"holds no snapshots", "output.snapshots"}));
}

TEST(Snapshots, OverlapsWithoutANeckAreCracks) {
  const io::TemporaryFolder folder;
  io::Frame frame;
  frame.ids = {4, 2, 7};
  frame.positions = {Vec3(0, 0, 0), Vec3(1.9, 0, 0), Vec3(3.8, 0, 0)};
  frame.radii = {1.0, 1.0, 1.0};
  io::write_vtp(folder / "particles_000000.vtp", frame);
  io::ContactFrame network;
  network.segments = {{frame.positions[1], frame.positions[0]}};
  network.arrays = {{"i", 1, std::vector<std::int64_t>{2}}, {"j", 1, std::vector<std::int64_t>{4}}};
  io::write_vtp(folder / "contacts_000000.vtp", network);
  const Moment moment = read_particles(folder / "particles_000000.vtp");
  ASSERT_EQ(moment.state.contacts.size(), 1U);
  EXPECT_EQ(moment.state.particles.id, (std::vector<std::int64_t>{2, 4, 7}));
  ASSERT_EQ(moment.state.cracks.size(), 1U);
  EXPECT_EQ(moment.state.cracks.i[0], 0);
  EXPECT_EQ(moment.state.cracks.j[0], 2);
  EXPECT_TRUE(std::isnan(moment.state.contacts.rolling_path[0]));
}

TEST(WriteFindings, GivesThreeFilesThatReadBack) {
  const io::TemporaryFolder folder;
  sinter(folder, "periodic", {"packing.count=100", "stop.time=1"});
  const auto findings = analyze_result(folder / "out", "");
  write_findings(folder / "found", findings);
  EXPECT_EQ(io::read_series(folder / "found" / "series.csv").values.front().size(), findings.size());
  const io::Series network = io::read_series(folder / "found" / "network.csv");
  EXPECT_EQ(network.columns.front(), "time [s]");
  const auto json = nlohmann::json::parse(io::read_file_whole(folder / "found" / "distributions.json"));
  const auto& last = json["moments"].back();
  std::size_t counted = 0;
  for (const std::size_t count : last["distributions"]["degree"]["counts"]) counted += count;
  EXPECT_EQ(counted + last["distributions"]["degree"]["above"].get<std::size_t>() +
                last["distributions"]["degree"]["below"].get<std::size_t>(),
            100U);
}

}  // namespace
}  // namespace frit::analyze
