#include "io/frame_files.hpp"

#include "temporary_folder.hpp"

namespace frit::io {
namespace {

void expect_same_particles(const Frame& a, const Frame& b) {
  EXPECT_TRUE(same_bits(a.ids, b.ids));
  EXPECT_TRUE(same_bits(a.positions, b.positions));
  EXPECT_TRUE(same_bits(a.radii, b.radii));
}

void expect_same_frame(const Frame& a, const Frame& b) {
  expect_same_particles(a, b);
  EXPECT_EQ(a.time, b.time);
  EXPECT_EQ(a.cell.periodic, b.cell.periodic);
  EXPECT_TRUE(same_bits(a.cell.size, b.cell.size));
  EXPECT_TRUE(same_bits(a.origin, b.origin));
  ASSERT_EQ(a.arrays.size(), b.arrays.size());
  for (std::size_t k = 0; k < a.arrays.size(); ++k) expect_same_array(a.arrays[k], b.arrays[k]);
}

class FrameFiles : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(Formats, FrameFiles,
                         testing::Values(".xyz", ".extxyz", ".dump", ".lammpstrj", ".vtp", ".VTP"),
                         [](const auto& format) { return format.param.substr(1); });

TEST_P(FrameFiles, FreeParticlesSurviveTheRoundTripBitForBit) {
  const TemporaryFolder folder;
  for (const std::size_t count : {1u, 2u, 137u}) {
    const auto frame = awkward_frame(count);
    write_frame(folder / ("a" + GetParam()), frame);
    expect_same_frame(read_frame(folder / ("a" + GetParam())), frame);
  }
}

TEST_P(FrameFiles, PeriodicCellsSurviveTheRoundTripBitForBit) {
  const TemporaryFolder folder;
  auto frame = awkward_frame(30);
  frame.cell = {.periodic = true, .size = {1e-4 / 3.0, 2e-5 / 7.0, 1.0 / 3.0}};
  write_frame(folder / ("a" + GetParam()), frame);
  expect_same_frame(read_frame(folder / ("a" + GetParam())), frame);
}

TEST_P(FrameFiles, WritingTwiceGivesTheSameBytes) {
  const TemporaryFolder folder;
  write_frame(folder / ("a" + GetParam()), awkward_frame(40));
  write_frame(folder / ("b" + GetParam()), read_frame(folder / ("a" + GetParam())));
  EXPECT_EQ(bytes_of(folder / ("a" + GetParam())), bytes_of(folder / ("b" + GetParam())));
}

TEST_P(FrameFiles, MissingFileAndMissingFolderAreNamed) {
  const auto path = "no/such" + GetParam();
  EXPECT_EQ(message_of<InputError>([&] { read_frame(path); }),
            path + ": cannot be read: No such file or directory");
  const auto message = message_of<MachineError>([&] { write_frame(path, awkward_frame(2)); });
  EXPECT_TRUE(message.starts_with(path + ": ")) << message;
}

TEST(Convert, AChainThroughAllFormatsChangesNothing) {
  const TemporaryFolder folder;
  const auto frame = awkward_frame(60);
  write_frame(folder / "0.vtp", frame);
  std::string last = "0.vtp";
  for (const std::string next : {"1.xyz", "2.dump", "3.vtp", "4.lammpstrj", "5.extxyz"}) {
    write_frame(folder / next, read_frame(folder / last));
    last = next;
  }
  expect_same_frame(read_frame(folder / last), frame);
}

TEST(Convert, CsvKeepsIdsPositionsAndRadii) {
  const TemporaryFolder folder;
  const auto frame = awkward_frame(20);
  write_frame(folder / "a.csv", frame);
  const auto read = read_frame(folder / "a.csv");
  expect_same_particles(read, frame);
  EXPECT_TRUE(read.arrays.empty());
  EXPECT_FALSE(read.cell.periodic);
}

TEST(Convert, UnknownExtensionsAreFaultsThatListTheKnownOnes) {
  const std::string fault =
      "a.pdb: unknown extension '.pdb'; allowed: .csv, .xyz, .extxyz, .dump, .lammpstrj, .vtp";
  EXPECT_EQ(message_of<InputError>([] { read_frame("a.pdb"); }), fault);
  EXPECT_EQ(message_of<InputError>([] { write_frame("a.pdb", awkward_frame(1)); }), fault);
}

}  // namespace
}  // namespace frit::io
