#include <nlohmann/json.hpp>

#include "io/json.hpp"
#include "io/pvd.hpp"
#include "temporary_folder.hpp"

namespace frit::io {
namespace {

TEST(Pvd, EntriesSurviveTheRoundTrip) {
  const TemporaryFolder folder;
  const std::vector<PvdEntry> entries{{1.0 / 3.0, "snapshots/a.vtp", 0, "particles"},
                                      {1e-9, "snapshots/b & <c> \"d\".vtp", 1, "contacts"}};
  write_pvd(folder / "s.pvd", entries);
  const auto read = read_pvd(folder / "s.pvd");
  ASSERT_EQ(read.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) {
    EXPECT_EQ(read[k].time, entries[k].time);
    EXPECT_EQ(read[k].file, entries[k].file);
    EXPECT_EQ(read[k].part, entries[k].part);
    EXPECT_EQ(read[k].name, entries[k].name);
  }
}

TEST(Pvd, OtherFilesAreFaults) {
  const TemporaryFolder folder;
  const auto other = folder.write("a.pvd", "<html>");
  EXPECT_EQ(faults_of(other, [&] { read_pvd(other); }).at(0), "a.pvd: not a ParaView collection");
  const auto bare =
      folder.write("b.pvd", "<Collection><!-- <DataSet/> --><DataSet timestep=\"x\" file=\"a\"/>");
  EXPECT_EQ(faults_of(bare, [&] { read_pvd(bare); }),
            std::vector<std::string>{"b.pvd: entry 0: timestep and file are needed"});
}

TEST(Json, NumbersSurviveAndNaNBecomesNull) {
  const TemporaryFolder folder;
  write_json(folder / "a.json", {{"third", 1.0 / 3.0}, {"none", std::nan("")}, {"list", {1, 2}}});
  const auto read = nlohmann::json::parse(bytes_of(folder / "a.json"));
  EXPECT_EQ(read["third"].get<double>(), 1.0 / 3.0);
  EXPECT_TRUE(read["none"].is_null());
  EXPECT_EQ(read["list"].size(), 2u);
}

TEST(Json, BrokenTextDoesNotCostTheFile) {
  const TemporaryFolder folder;
  write_json(folder / "a.json", {{"name", "\xff"}});
  EXPECT_EQ(nlohmann::json::parse(bytes_of(folder / "a.json"))["name"], "\xef\xbf\xbd");
}

TEST(Json, MissingFolderIsAMachineErrorThatNamesTheFile) {
  const auto message = message_of<MachineError>([] { write_json("no/such.json", {}); });
  EXPECT_TRUE(message.starts_with("no/such.json: ")) << message;
}

}  // namespace
}  // namespace frit::io
