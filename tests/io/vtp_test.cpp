#include "io/vtp.hpp"

#include <cmath>
#include <random>

#include "io/vtp_blocks.hpp"
#include "io/xml_scan.hpp"
#include "temporary_folder.hpp"

namespace frit::io {
namespace {

TEST(VtpBlocks, ArraysOfAnyLengthSurvive) {
  std::mt19937_64 generator(3);
  constexpr std::size_t block = std::size_t{1} << 17;
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, block - 1, block, block + 1, 3 * block, 3 * block + 8}) {
    std::vector<std::byte> array(size), read(size);
    for (auto& byte : array) byte = static_cast<std::byte>(generator() % 5);
    std::string data = "before";
    append_compressed(data, array);
    const auto offset = std::string("before").size();
    EXPECT_EQ(read_compressed(data, offset, read), "") << size;
    EXPECT_TRUE(same_bits(array, read)) << size;
    if (size == 0) continue;
    EXPECT_NE(read_compressed(data, offset, std::span(read).first(size - 1)), "")
        << "another length than stored";
    EXPECT_NE(read_compressed(std::string_view(data).substr(0, data.size() - 1), offset, read), "")
        << "cut off";
  }
}

TEST(Vtp, LargeArraysOfSeveralBlocksSurvive) {
  const TemporaryFolder folder;
  PolyData data;
  std::vector<double> values;
  for (int k = 0; k < 40000; ++k) {
    data.points.emplace_back(k / 3.0, -k, 1e-9 * k);
    values.push_back(std::sqrt(k));
  }
  data.point_arrays = {{"root", 1, values}};
  write_vtp(folder / "a.vtp", data);
  const auto read = read_vtp(folder / "a.vtp");
  EXPECT_TRUE(same_bits(read.points, data.points));
  expect_same_array(read.point_arrays.at(0), data.point_arrays[0]);
}

ContactFrame small_network() {
  ContactFrame frame;
  frame.time = 2.5;
  frame.cell = {.periodic = true, .size = {10, 10, 10}};
  Contacts contacts;
  contacts.resize(2);
  contacts.i = {0, 0};
  contacts.j = {1, 1};
  contacts.image = {Image{0, 0, 0}, Image{-1, 0, 1}};
  frame.segments = contact_segments({{1, 1, 1}, {9, 2, 3}}, frame.cell, contacts);
  frame.arrays = {{"neck_radius", 1, std::vector<double>{0.25, 0.5}},
                  {"j", 1, std::vector<std::int64_t>{1, 1}}};
  return frame;
}

TEST(Vtp, SegmentsGoToThePeriodicCopy) {
  const auto segments = small_network().segments;
  EXPECT_EQ(segments[0].begin, Vec3(1, 1, 1));
  EXPECT_EQ(segments[0].end, Vec3(9, 2, 3));
  EXPECT_EQ(segments[1].begin, Vec3(1, 1, 1));
  EXPECT_EQ(segments[1].end, Vec3(-1, 2, 13));
}

TEST(Vtp, NetworksSurviveTheRoundTrip) {
  const TemporaryFolder folder;
  const auto frame = small_network();
  write_vtp(folder / "c.vtp", frame);
  const auto read = read_vtp(folder / "c.vtp");
  EXPECT_EQ(read.cells, PolyCells::segments);
  ASSERT_EQ(read.points.size(), 4u);
  EXPECT_EQ(read.points[3], Vec3(-1, 2, 13));
  ASSERT_EQ(read.cell_arrays.size(), 2u);
  for (std::size_t k = 0; k < 2; ++k) expect_same_array(read.cell_arrays[k], frame.arrays[k]);
  expect_same_array(read.file_arrays.at(0), {"TimeValue", 1, std::vector<double>{2.5}});
  expect_same_array(read.file_arrays.at(1), {"CellSize", 3, std::vector<double>{10, 10, 10}});
}

TEST(Vtp, NetworkWithoutContactsIsAFileToo) {
  const TemporaryFolder folder;
  write_vtp(folder / "c.vtp", ContactFrame{});
  EXPECT_TRUE(read_vtp(folder / "c.vtp").points.empty());
}

TEST(Vtp, NamesMayHoldAnyCharacter) {
  const TemporaryFolder folder;
  PolyData data;
  data.points = {{1, 2, 3}};
  data.point_arrays = {{"a<b> & \"c\" [m/s]", 1, std::vector<double>{1}}};
  write_vtp(folder / "a.vtp", data);
  EXPECT_EQ(read_vtp(folder / "a.vtp").point_arrays.at(0).name, data.point_arrays[0].name);
}

std::string with(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, text.npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(Vtp, EachFaultNamesFileAndArray) {
  const TemporaryFolder folder;
  write_vtp(folder / "a.vtp", awkward_frame(3));
  const auto good = bytes_of(folder / "a.vtp");
  const std::string form =
      "a.vtp: not a VTP file in the form that frit writes (PolyData, LittleEndian, UInt64, "
      "vtkZLibDataCompressor)";
  const std::vector<std::pair<std::string, std::string>> table{
      {"", form},
      {"hello", form},
      {with(good, "UInt64", "UInt32"), form},
      {with(good, "encoding=\"raw\"", "encoding=\"base64\""),
       "a.vtp: the raw AppendedData is missing; the file may be cut off"},
      {good.substr(0, good.find("<AppendedData")),
       "a.vtp: the raw AppendedData is missing; the file may be cut off"},
      {with(good, "NumberOfPoints=\"3\"", "NumberOfPoints=\"4\""),
       "a.vtp: 4 points, 3 vertices, 0 lines: not what frit writes"},
      {with(good, "NumberOfPoints=\"3\"", "NumberOfPoints=\"-3\""), "a.vtp: NumberOfPoints '-3': no count"},
      {with(good, "NumberOfPoints=\"3\"", "NumberOfPoints=\"999999999999\""),
       "a.vtp: NumberOfPoints 999999999999 is more than the file can hold"},
      {with(with(good, "NumberOfPoints=\"3\"", "NumberOfPoints=\"4\""), "NumberOfVerts=\"3\"",
            "NumberOfVerts=\"4\""),
       "a.vtp: array 'id': its blocks do not make the 32 bytes that are needed"},
      {with(good, "type=\"Int64\" Name=\"id\"", "type=\"Int32\" Name=\"id\""),
       "a.vtp: array 'id': type 'Int32', allowed: Float64 or Int64"},
      {with(good, "Name=\"radius\" NumberOfComponents=\"1\"", "Name=\"radius\" NumberOfComponents=\"2\""),
       "a.vtp: array 'radius': '2' components, allowed: 1 or 3"},
      {with(good, "Name=\"radius\"", "Name=\"diameter\""),
       "a.vtp: the point array 'radius' (Float64, 1 component) is missing"},
      {with(good, "offset=\"0\"", "offset=\"999999\""),
       "a.vtp: array 'TimeValue': it begins behind the end of the file"},
      {with(good, "format=\"appended\"", "format=\"ascii\""),
       "a.vtp: array 'TimeValue': it is not appended data"},
      {with(good, "Name=\"Points\" NumberOfComponents=\"3\" format=\"appended\"",
            "Name=\"Points\" format=\"inline\""),
       "a.vtp: array 'Points': it is not appended data"}};
  for (const auto& [text, fault] : table) {
    const auto path = folder.write("a.vtp", text);
    EXPECT_EQ(faults_of(path, [&] { read_vtp_frame(path); }), std::vector{fault});
  }
}

TEST(Vtp, ParticlesThatCannotBeAreFaults) {
  const TemporaryFolder folder;
  auto frame = awkward_frame(4);
  frame.radii[1] = 0.0;
  frame.radii[2] = std::nan("");
  frame.positions[3].x() = INFINITY;
  frame.ids[2] = frame.ids[0];
  write_vtp(folder / "a.vtp", frame);
  EXPECT_EQ(faults_of(folder / "a.vtp", [&] { read_vtp_frame(folder / "a.vtp"); }),
            (std::vector<std::string>{
                "a.vtp: particle 2: array 'radius': the radius is not finite",
                "a.vtp: particle 3: array 'Points': a coordinate is not finite",
                "a.vtp: particle 1: column 'radius': 0 m is not positive; a radius must be > 0",
                "a.vtp: particle 2: column 'id': 2 is already the id of the particle at a.vtp: particle 0"}));
}

TEST(Vtp, NetworksAreNotParticles) {
  const TemporaryFolder folder;
  write_vtp(folder / "c.vtp", small_network());
  EXPECT_EQ(faults_of(folder / "c.vtp", [&] { read_vtp_frame(folder / "c.vtp"); }).at(0),
            "c.vtp: holds a contact network, not particles");
}

#ifdef FRIT_CHECKS
TEST(Vtp, ArraysOfAnotherLengthBreakTheContract) {
  PolyData data;
  data.points = {{1, 2, 3}, {4, 5, 6}};
  data.point_arrays = {{"a", 1, std::vector<double>{1}}};
  EXPECT_THROW(write_vtp("never.vtp", data), ContractError);
  Frame frame = awkward_frame(3);
  frame.arrays[1].components = 1;
  EXPECT_THROW(write_vtp("never.vtp", frame), ContractError);
  EXPECT_FALSE(std::filesystem::exists("never.vtp"));
}
#endif

TEST(XmlScan, TagsCommentsAndTornTags) {
  std::size_t position = 0;
  const std::string text = "x <!-- <a/> --><b c=\"1 &lt; 2\"  d=\"\"/> y </b><torn";
  const auto first = next_tag(text, position);
  ASSERT_TRUE(first.has_value());
  EXPECT_EQ(first->name, "b");
  EXPECT_EQ(first->get("c"), "1 < 2");
  EXPECT_EQ(first->get("e"), "");
  EXPECT_EQ(next_tag(text, position)->name, "/b");
  EXPECT_FALSE(next_tag(text, position).has_value());
}

}  // namespace
}  // namespace frit::io
