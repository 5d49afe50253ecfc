#include "io/packing_csv.hpp"

#include "temporary_folder.hpp"

namespace frit::io {
namespace {

PackingTable read_text(std::string_view text) {
  const TemporaryFolder folder;
  return read_packing_csv(folder.write("packing.csv", text));
}

std::vector<std::string> faults_in(std::string_view text) {
  const TemporaryFolder folder;
  const auto path = folder.write("packing.csv", text);
  return faults_of(path, [&] { read_packing_csv(path); });
}

TEST(PackingCsv, ColumnsMayStandInAnyOrderWithUnitsAndOthersBetween) {
  const auto packing = read_text("name,radius [mm],z [nm],y [cm],x [um]\nP1,1,2,3,4\n");
  ASSERT_EQ(packing.size(), 1u);
  EXPECT_EQ(packing.radii[0], 1e-3);
  EXPECT_EQ(packing.positions[0], Vec3(4e-6, 3e-2, 2e-9));
  EXPECT_EQ(packing.ids[0], 0);
}

TEST(PackingCsv, UnitsGiveTheSameBitsAsTheNumberInMetres) {
  for (const auto* unit : {"um", "\xc2\xb5m", "\xce\xbcm"}) {
    const auto packing = read_text(std::string("x [") + unit + "],y,z,radius [" + unit + "]\n3,0,0,7\n");
    EXPECT_EQ(packing.positions[0].x(), 3e-6) << unit;
    EXPECT_EQ(packing.radii[0], 7e-6) << unit;
  }
}

TEST(PackingCsv, SeparatorsLineEndsAndCommentsDoNotMatter) {
  const std::string rows = "x,y,z,radius\n1,2,3,4\n5,6,7,8\n";
  const auto plain = read_text(rows);
  const auto replaced = [&](char separator) {
    std::string text = rows;
    std::ranges::replace(text, ',', separator);
    return text;
  };
  for (const std::string& text :
       {replaced(';'), replaced('\t'), "\xef\xbb\xbf" + rows, "# made by hand\n\n" + rows,
        std::string("x,y,z,radius\r\n\r\n 1, 2 ,3,4\r\n# between\r\n   \r\n5,6,7,8"),
        std::string("\"x\",\"y [m]\",z,radius\n\"1\",2,3,4\n5,6,7,+8\n")}) {
    const auto packing = read_text(text);
    EXPECT_TRUE(same_bits(packing.positions, plain.positions)) << text;
    EXPECT_TRUE(same_bits(packing.radii, plain.radii)) << text;
  }
}

TEST(PackingCsv, EmptyCellsOfOtherColumnsKeepTheirPlace) {
  const auto packing = read_text("\tx\ty\tz\tradius\tnote\n\t1\t2\t3\t4\t\n");
  EXPECT_EQ(packing.positions[0], Vec3(1, 2, 3));
}

TEST(PackingCsv, SeparatorsInQuotesBelongToTheCell) {
  EXPECT_EQ(read_text("note,x,y,z,radius\n\"a, b\",1,2,3,4\n").radii[0], 4.0);
}

TEST(PackingCsv, WrittenAndReadGivesTheSameBits) {
  const TemporaryFolder folder;
  const auto frame = awkward_frame(50);
  write_packing_csv(folder / "p.csv", {frame.ids, frame.positions, frame.radii});
  const auto packing = read_packing_csv(folder / "p.csv");
  EXPECT_TRUE(same_bits(packing.ids, frame.ids));
  EXPECT_TRUE(same_bits(packing.positions, frame.positions));
  EXPECT_TRUE(same_bits(packing.radii, frame.radii));
}

struct FaultCase {
  std::string_view text;
  std::vector<std::string> faults;
};

TEST(PackingCsv, EachFaultNamesLineColumnAndValue) {
  const std::vector<FaultCase> table{
      {"", {"packing.csv: the file is empty; its first line must name the columns"}},
      {"\n# only a comment\n", {"packing.csv: the file is empty; its first line must name the columns"}},
      {"x,y,z,radius\n", {"packing.csv: no particles: no row follows the header in line 1"}},
      {"x,y,r\n1,2,3\n",
       {"packing.csv:1: column 'z' is missing; the header names 'x', 'y', 'r'",
        "packing.csv:1: column 'radius' is missing; the header names 'x', 'y', 'r'"}},
      {"x [furlong],y,z,radius\n1,2,3,4\n",
       {"packing.csv:1: column 'x': unknown unit 'furlong'; allowed: m, cm, mm, um, nm"}},
      {"x,x,y,z,radius\n1,1,2,3,4\n", {"packing.csv:1: column 'x' stands there twice"}},
      {"x,y,z,radius\n1,2,abc,4\n", {"packing.csv:2: column 'z': 'abc' is not a number"}},
      {"x,y,z,radius\n1,,3,4\n", {"packing.csv:2: column 'y': the cell is empty, a number is needed"}},
      {"x,y,z,radius\nnan,2,3,4\n", {"packing.csv:2: column 'x': 'nan' is not finite"}},
      {"x,y,z,radius\n1,2,3,inf\n", {"packing.csv:2: column 'radius': 'inf' is not finite"}},
      {"x,y,z,radius\n1,2,3,1e999\n",
       {"packing.csv:2: column 'radius': '1e999' is beyond the range of a double"}},
      {"x;y;z;radius\n1,5;2;3;4\n",
       {"packing.csv:2: column 'x': '1,5' is not a number (decimals need a point)"}},
      {"x,y,z,radius\n1,2,3,0\n",
       {"packing.csv:2: column 'radius': 0 m is not positive; a radius must be > 0"}},
      {"x,y,z,radius [mm]\n1,2,3,-1\n",
       {"packing.csv:2: column 'radius': -0.001 m is not positive; a radius must be > 0"}},
      {"x,y,z,radius\n1,2,3\n1,2,3,4,5\n",
       {"packing.csv:2: 3 cells, but the header has 4 columns",
        "packing.csv:3: 5 cells, but the header has 4 columns"}},
      {"id,x,y,z,radius\n5,1,2,3,4\n5,2,2,3,4\n1.5,3,2,3,4\n",
       {"packing.csv:4: column 'id': '1.5' is not a whole number",
        "packing.csv:3: column 'id': 5 is already the id of the particle at packing.csv:2"}},
      {"x,y,z,radius\n# c\n1,2,0,4\n5,5,5,1\n1,2,-0,3\n1,2,0,1\n",
       {"packing.csv:5: columns 'x', 'y', 'z': (1, 2, -0) m is already the centre of the particle at "
        "packing.csv:3",
        "packing.csv:6: columns 'x', 'y', 'z': (1, 2, 0) m is already the centre of the particle at "
        "packing.csv:3"}}};
  for (const auto& [text, faults] : table) EXPECT_EQ(faults_in(text), faults) << text;
}

TEST(PackingCsv, FaultsOfDifferentKindsAreReportedTogether) {
  const auto faults = faults_in("x,y,z,radius\n1,2,3,-4\n1,b,3,4\n1,2,3,1\n1,2\n");
  EXPECT_EQ(faults,
            (std::vector<std::string>{
                "packing.csv:3: column 'y': 'b' is not a number",
                "packing.csv:5: 2 cells, but the header has 4 columns",
                "packing.csv:2: column 'radius': -4 m is not positive; a radius must be > 0",
                "packing.csv:4: columns 'x', 'y', 'z': (1, 2, 3) m is already the centre of the particle at "
                "packing.csv:2"}));
}

TEST(PackingCsv, TwentyFaultsAreSpelledOutAndTheRestCounted) {
  std::string text = "x,y,z,radius\n";
  for (int row = 0; row < 33; ++row) text += std::to_string(row) + ",a,0,1\n";
  const auto faults = faults_in(text);
  ASSERT_EQ(faults.size(), 21u);
  EXPECT_EQ(faults[19], "packing.csv:21: column 'y': 'a' is not a number");
  EXPECT_EQ(faults[20], "and 13 more");
}

TEST(PackingCsv, MissingFileIsAFaultOfTheUser) {
  EXPECT_EQ(message_of<InputError>([] { read_packing_csv("no/such.csv"); }),
            "no/such.csv: cannot be read: No such file or directory");
}

}  // namespace
}  // namespace frit::io
