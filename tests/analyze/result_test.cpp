#include "analyze/result.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "run/result_folder.hpp"
#include "run/samples.hpp"

namespace frit::analyze {
namespace {

using run::samples::mentions;

std::vector<std::string> faults_of(const std::filesystem::path& folder) {
  try {
    read_result(folder);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

TEST(Result, HoldsSeriesKeysAndScaleOfARun) {
  const io::TemporaryFolder folder;
  run::ResultFolder files(folder / "out");
  run::samples::Recorder recorder;
  run::run_case(run::samples::pair_case(folder, {"contact.sliding_resistance=0.02"}), {&files, &recorder});
  const Result result = read_result(folder / "out");
  EXPECT_EQ(result.keys.at("contact.sliding_resistance"), "0.02");
  EXPECT_EQ(result.keys.at("stop.time"), "60");
  ASSERT_NE(result.column("time [s]"), nullptr);
  EXPECT_EQ(*result.column("time [s]"), recorder.column("time [s]"));
  EXPECT_EQ(result.column("nothing"), nullptr);
  EXPECT_NEAR(result.tau_per_theta, run::samples::gamma / std::pow(run::samples::radius, 4),
              1e-9 * result.tau_per_theta);
}

TEST(Result, ThatIsNoneIsAFault) {
  const io::TemporaryFolder folder;
  EXPECT_TRUE(mentions(faults_of(folder / "nowhere"), {"nowhere", "no such folder"}));
  std::filesystem::create_directory(folder / "out");
  EXPECT_TRUE(mentions(faults_of(folder / "out"), {"out", "series.csv"}));
  folder.write("out/series.csv", "time [s]\n");
  EXPECT_TRUE(mentions(faults_of(folder / "out"), {"case.toml"}));
  folder.write("out/case.toml", "[broken");
  EXPECT_TRUE(mentions(faults_of(folder / "out"), {"case.toml", "not the case of a result"}));
  folder.write("out/case.toml", "title = \"x\"\n");
  EXPECT_TRUE(mentions(faults_of(folder / "out"), {"series.csv", "no rows"}));
  folder.write("out/series.csv", "time [s]\n1\n");
  folder.write("out/summary.json", "{ broken");
  EXPECT_TRUE(std::isnan(read_result(folder / "out").tau_per_theta));
}

}  // namespace
}  // namespace frit::analyze
