// Extended XYZ and LAMMPS dump: what is written, what foreign files may look like, what is wrong with a file.
#include "io/extended_xyz.hpp"
#include "io/lammps_dump.hpp"
#include "temporary_folder.hpp"

namespace frit::io {
namespace {

Frame small_frame() {
  Frame frame;
  frame.time = 0.5;
  frame.ids = {4, 1};
  frame.positions = {{1, 2, 3}, {0.25, 0, 0}};
  frame.radii = {1.5, 0.125};
  frame.arrays = {{"velocity", 3, std::vector<double>{1, 0, -2, 0.5, 0, 0}},
                  {"neck radius", 1, std::vector<double>{1, 2}},
                  {"group", 1, std::vector<std::int64_t>{7, 8}}};
  return frame;
}

Frame periodic_frame() {
  Frame frame = small_frame();
  frame.cell = {.periodic = true, .size = {4, 5, 6}};
  frame.origin = {-1, 0, 0.5};
  return frame;
}

TEST(ExtendedXyz, FilesLookAsDocumented) {
  const TemporaryFolder folder;
  write_extended_xyz(folder / "a.xyz", periodic_frame());
  EXPECT_EQ(bytes_of(folder / "a.xyz"),
            "2\nLattice=\"4 0 0 0 5 0 0 0 6\" Origin=\"-1 0 0.5\" pbc=\"T T T\" "
            "Properties=id:I:1:pos:R:3:radius:R:1:velocity:R:3:neck_radius:R:1:group:I:1 Time=0.5\n"
            "4 1 2 3 1.5 1 0 -2 1 7\n1 0.25 0 0 0.125 0.5 0 0 2 8\n");
}

TEST(LammpsDump, FilesLookAsDocumented) {
  const TemporaryFolder folder;
  write_lammps_dump(folder / "a.dump", small_frame());
  EXPECT_EQ(
      bytes_of(folder / "a.dump"),
      "ITEM: TIME\n0.5\nITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ff ff ff\n"
      "-0.5 2.5\n-0.125 3.5\n-0.125 4.5\nITEM: ATOMS id element x y z radius vx vy vz neck_radius group\n"
      "4 X 1 2 3 1.5 1.0 0.0 -2.0 1.0 7\n1 X 0.25 0 0 0.125 0.5 0.0 0.0 2.0 8\n");
}

TEST(LammpsDump, PeriodicCellsKeepTheirCorner) {
  const TemporaryFolder folder;
  write_lammps_dump(folder / "a.dump", periodic_frame());
  const auto frame = read_lammps_dump(folder / "a.dump");
  EXPECT_TRUE(frame.cell.periodic);
  EXPECT_EQ(frame.cell.size, Vec3(4, 5, 6));
  EXPECT_EQ(frame.origin, Vec3(-1, 0, 0.5));
}

Frame read_xyz_text(std::string_view text) {
  const TemporaryFolder folder;
  return read_extended_xyz(folder.write("a.xyz", text));
}

Frame read_dump_text(std::string_view text) {
  const TemporaryFolder folder;
  return read_lammps_dump(folder.write("a.dump", text));
}

TEST(ExtendedXyz, ForeignPropertiesAndKeysArePassedOver) {
  const auto frame = read_xyz_text(
      "1\nfinal Lattice=\"2 0 0 0 2 0 0 0 2\" config=a Properties=species:S:1:pos:R:3:stress:R:9:radius:R:1\n"
      "Cu 1 1 1 1 2 3 4 5 6 7 8 9 0.5\n\n");
  EXPECT_TRUE(frame.cell.periodic) << "a Lattice without pbc is periodic";
  EXPECT_EQ(frame.radii, std::vector{0.5});
  EXPECT_EQ(frame.ids, std::vector<std::int64_t>{0});
  EXPECT_TRUE(frame.arrays.empty());
}

TEST(ExtendedXyz, TheLastOfSeveralFramesIsRead) {
  const std::string keys = "\nProperties=pos:R:3:radius:R:1 Time=";
  const auto frame = read_xyz_text("1" + keys + "1\n0 0 0 1\n2" + keys + "2\n0 0 0 1\n3 0 0 1\n");
  EXPECT_EQ(frame.size(), 2u);
  EXPECT_EQ(frame.time, 2.0);
}

TEST(LammpsDump, ForeignColumnsAndSectionsAreUnderstood) {
  const auto frame = read_dump_text(
      "ITEM: UNITS\nsi\nITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n1\nITEM: BOX BOUNDS fm ff ss\n0 1\n0 "
      "1\n0 1\n"
      "ITEM: ATOMS element type xu yu zu radius omegax omegay omegaz q_x q_y q_z a_x \n"
      "Cu 1 1 2 3 0.5 1 2 3 4 5.5 6 7 \n");
  EXPECT_FALSE(frame.cell.periodic);
  EXPECT_EQ(frame.positions[0], Vec3(1, 2, 3));
  ASSERT_EQ(frame.arrays.size(), 4u);
  expect_same_array(frame.arrays[0], {"type", 1, std::vector<std::int64_t>{1}});
  expect_same_array(frame.arrays[1], {"spin", 3, std::vector<std::int64_t>{1, 2, 3}});
  expect_same_array(frame.arrays[2], {"q", 3, std::vector<double>{4, 5.5, 6}});
  expect_same_array(frame.arrays[3], {"a_x", 1, std::vector<std::int64_t>{7}});
}

struct FaultCase {
  std::string text;
  std::string fault;
};

TEST(ExtendedXyz, EachFaultNamesLineAndValue) {
  const std::string keys = "Properties=pos:R:3:radius:R:1", row = "\n0 0 0 1\n";
  const std::string cell = "\nLattice=\"2 0 0 0 2 0 0 0 2\" ";
  const std::vector<FaultCase> table{
      {"", "a.xyz: the file is empty"},
      {"many\n" + keys + row, "a.xyz:1: number of particles: 'many' is not a whole number"},
      {"0\n" + keys + row, "a.xyz:1: number of particles: 0 is not positive"},
      {"99999999999\n" + keys + row,
       "a.xyz:1: number of particles: 99999999999, but the file can hold 4 at most"},
      {"2\n" + keys + row, "a.xyz:3: the file ends after 1 of 2 particles"},
      {"1\nTime=1" + row, "a.xyz:2: key 'Properties' is missing"},
      {"1\nProperties=pos:R:3" + row, "a.xyz:2: column 'radius' is missing"},
      {"1\nProperties=radius:R:1:x:R:3" + row,
       "a.xyz:2: column 'position' is missing (pos in extended XYZ; x y z or xu yu zu in a dump)"},
      {"1\nProperties=pos:R:2:radius:R:1" + row, "a.xyz:2: column 'position' must hold 3 numbers"},
      {"1\nProperties=pos:Q:3:radius:R:1" + row,
       "a.xyz:2: key 'Properties': 'pos' is not of the form name:R, I, S or L:1 to 9"},
      {"1\nProperties=pos:R:3:radius:R:1:a" + row,
       "a.xyz:2: key 'Properties': not a list of name:kind:count"},
      {"1\nProperties=pos:R:3:pos:R:3:radius:R:1" + row, "a.xyz:2: column 'position' stands there twice"},
      {"1\n" + keys + " Time=\"1" + row, "a.xyz:2: key 'Time': the quote does not end"},
      {"1\n" + keys + " Time=soon" + row, "a.xyz:2: key 'Time': 'soon' is not a number"},
      {"1\nLattice=\"1 2\" " + keys + row, "a.xyz:2: key 'Lattice': 2 numbers, 9 are needed"},
      {"1\nLattice=\"1 0 0 0 0 0 0 0 1\" " + keys + row, "a.xyz:2: key 'Lattice': edge 0 is not positive"},
      {"1\nLattice=\"1 0 0 1 1 0 0 0 1\" " + keys + row,
       "a.xyz:2: key 'Lattice': the cell is not rectangular along x, y and z"},
      {"1" + cell + "pbc=\"T T F\" " + keys + row,
       "a.xyz:2: key 'pbc': 'T T F'; a cell must be periodic in all directions (T T T) or in none (F F F)"},
      {"1\npbc=\"T T T\" " + keys + row, "a.xyz:2: key 'Lattice' is missing, but pbc says periodic"},
      {"1\n" + keys + "\n0 0 0\n\n\n", "a.xyz:3: 3 cells, 4 are needed"},
      {"1\n" + keys + "\n0 x 0 1\n", "a.xyz:3: column 'position': 'x' is not a number"},
      {"1\n" + keys + "\n0 0 0 nan\n", "a.xyz:3: column 'radius': 'nan' is not finite"},
      {"1\n" + keys + "\n0 0 0 -1\n", "a.xyz:3: column 'radius': -1 m is not positive; a radius must be > 0"},
      {"1\nProperties=id:R:1:pos:R:3:radius:R:1\n1.5 0 0 0 1\n",
       "a.xyz:3: column 'id': '1.5' is not a whole number"},
      {"2\nProperties=id:I:1:pos:R:3:radius:R:1\n1 0 0 0 1\n1 2 0 0 1\n",
       "a.xyz:4: column 'id': 1 is already the id of the particle at a.xyz:3"},
      {"2\n" + keys + row + "0 0 0 1\n",
       "a.xyz:4: columns 'x', 'y', 'z': (0, 0, 0) m is already the centre of the particle at a.xyz:3"},
      {"1\n" + keys + row + "rest\n", "a.xyz:4: number of particles: 'rest' is not a whole number"}};
  const TemporaryFolder folder;
  for (const auto& [text, fault] : table) {
    const auto path = folder.write("a.xyz", text);
    EXPECT_EQ(faults_of(path, [&] { read_extended_xyz(path); }), std::vector{fault}) << text;
  }
}

TEST(LammpsDump, EachFaultNamesLineAndValue) {
  const std::string count = "ITEM: NUMBER OF ATOMS\n1\n", box = "ITEM: BOX BOUNDS pp pp pp\n0 1\n0 1\n0 1\n";
  const std::string atoms = "ITEM: ATOMS id x y z radius\n1 0 0 0 1\n";
  const std::vector<FaultCase> table{
      {"", "a.dump: the file is empty"},
      {"1\n2\n", "a.dump:1: a line that begins with 'ITEM: ' is needed, not '1'"},
      {"ITEM: TIMESTEP\n", "a.dump:1: the file ends within a section"},
      {"ITEM: TIME\nnan\n" + count + atoms, "a.dump:2: TIME: 'nan' is not finite"},
      {atoms, "a.dump:1: no NUMBER OF ATOMS before the atoms"},
      {"ITEM: NUMBER OF ATOMS\n1000000000\n" + atoms,
       "a.dump:2: number of particles: 1000000000, but the file can hold 4 at most"},
      {"ITEM: NUMBER OF ATOMS\n2\n" + atoms, "a.dump:4: the file ends after 1 of 2 particles"},
      {"ITEM: BOX BOUNDS xy xz yz pp pp pp\n0 1 0\n",
       "a.dump:1: BOX BOUNDS: the cell is not rectangular along x, y and z"},
      {"ITEM: BOX BOUNDS pp pp ff\n0 1\n",
       "a.dump:1: BOX BOUNDS: ' pp pp ff'; a cell must be periodic in all directions (pp pp pp) or in none"},
      {"ITEM: BOX BOUNDS pp pp pp\n0 1\n1 1\n0 1\n",
       "a.dump:3: BOX BOUNDS: the upper bound is not above the lower one"},
      {"ITEM: BOX BOUNDS pp pp pp\n0\n", "a.dump:2: BOX BOUNDS: two numbers are needed"},
      {"ITEM: BOX BOUNDS pp pp pp\n0 a\n", "a.dump:2: BOX BOUNDS: 'a' is not a number"},
      {count + box + "ITEM: ATOMS id x y z\n1 0 0 0\n", "a.dump:7: column 'radius' is missing"},
      {count + box + "ITEM: ATOMS id xs ys zs radius\n1 0 0 0 1\n",
       "a.dump:7: column 'position' is missing (pos in extended XYZ; x y z or xu yu zu in a dump)"},
      {count + box + "ITEM: ATOMS id x y z radius\n1 0 0 0 0\n",
       "a.dump:8: column 'radius': 0 m is not positive; a radius must be > 0"},
      {count + box + "ITEM: ATOMS id x y z radius q\n1 0 0 0 1 abc\n",
       "a.dump:8: column 'q': 'abc' is not a number"}};
  const TemporaryFolder folder;
  for (const auto& [text, fault] : table) {
    const auto path = folder.write("a.dump", text);
    EXPECT_EQ(faults_of(path, [&] { read_lammps_dump(path); }), std::vector{fault}) << text;
  }
}

}  // namespace
}  // namespace frit::io
