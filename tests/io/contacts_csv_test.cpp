#include "io/contacts_csv.hpp"

#include "temporary_folder.hpp"

namespace frit::io {
namespace {

ContactTable read_text(std::string_view text, std::size_t particle_count) {
  const TemporaryFolder folder;
  return read_contacts_csv(folder.write("necks.csv", text), particle_count);
}

std::vector<std::string> faults_in(std::string_view text, std::size_t particle_count) {
  const TemporaryFolder folder;
  const auto path = folder.write("necks.csv", text);
  return faults_of(path, [&] { read_contacts_csv(path, particle_count); });
}

TEST(ContactsCsv, PairsAreReadAsWritten) {
  const auto contacts = read_text("neck_radius [um],j,i\n2,0,1\n3,2,0\n", 3);
  EXPECT_EQ(contacts.i, (std::vector<std::int32_t>{1, 0}));
  EXPECT_EQ(contacts.j, (std::vector<std::int32_t>{0, 2}));
  EXPECT_EQ(contacts.neck_radius, (std::vector<double>{2e-6, 3e-6}));
}

TEST(ContactsCsv, NeckRadiiAreOptional) {
  const auto contacts = read_text("i;j\n0;1\n", 2);
  EXPECT_EQ(contacts.size(), 1u);
  EXPECT_TRUE(contacts.neck_radius.empty());
}

TEST(ContactsCsv, HeaderAloneMeansNoContacts) { EXPECT_EQ(read_text("i,j\n", 2).size(), 0u); }

TEST(ContactsCsv, EachFaultNamesLineColumnAndValue) {
  struct FaultCase {
    std::string_view text;
    std::string fault;
  };
  const std::vector<FaultCase> table{
      {"", "necks.csv: the file is empty; its first line must name the columns"},
      {"i\n0\n", "necks.csv:1: column 'j' is missing; the header names 'i'"},
      {"i,j,neck_radius [kg]\n0,1,1\n",
       "necks.csv:1: column 'neck_radius': unknown unit 'kg'; allowed: m, cm, mm, um, nm"},
      {"i,j\n0,3\n", "necks.csv:2: column 'j': there is no particle 3; allowed: 0 to 2"},
      {"i,j\n-1,1\n", "necks.csv:2: column 'i': there is no particle -1; allowed: 0 to 2"},
      {"i,j\n0,1.5\n", "necks.csv:2: column 'j': '1.5' is not a whole number"},
      {"i,j\n0,99999999999999999999\n", "necks.csv:2: column 'j': '99999999999999999999' is beyond 64 bits"},
      {"i,j\n1,1\n", "necks.csv:2: columns 'i', 'j': particle 1 cannot touch itself"},
      {"i,j\n0,1\n1,2\n1,0\n",
       "necks.csv:4: columns 'i', 'j': the contact of 1 and 0 is already listed at necks.csv:2"},
      {"i,j\n0,1\n0,1\n",
       "necks.csv:3: columns 'i', 'j': the contact of 0 and 1 is already listed at necks.csv:2"},
      {"i,j,neck_radius\n0,1,0\n",
       "necks.csv:2: column 'neck_radius': 0 m is not positive; a neck radius must be > 0"},
      {"i,j,neck_radius\n0,1,nan\n", "necks.csv:2: column 'neck_radius': 'nan' is not finite"},
      {"i,j\n0,1,2\n", "necks.csv:2: 3 cells, but the header has 2 columns"}};
  for (const auto& [text, fault] : table) EXPECT_EQ(faults_in(text, 3), std::vector{fault}) << text;
}

TEST(ContactsCsv, WithoutParticlesNoContactIsPossible) {
  EXPECT_EQ(faults_in("i,j\n0,1\n", 0).at(0),
            "necks.csv:2: column 'i': there is no particle 0; there are none");
}

TEST(ContactsCsv, AllFaultsAreReportedTogether) {
  EXPECT_EQ(faults_in("i,j,neck_radius\n0,9,-1\n1,1,x\n0,1,1\n1,0,1\n", 3).size(), 5u);
}

}  // namespace
}  // namespace frit::io
