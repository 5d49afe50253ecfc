#include "analyze/centres.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "analyze/analysis.hpp"
#include "observe/samples.hpp"
#include "run/samples.hpp"

namespace frit::analyze {
namespace {

using observe::samples::Random;
using run::samples::mentions;

constexpr double R = 5e-6;

struct Row {
  std::int64_t id;
  Vec3 x;
};

// A jittered cubic lattice of 6^3 spheres with ids 1000, 1003, ...
std::vector<Row> lattice() {
  Random random(11);
  std::vector<Row> rows;
  for (int code = 0; code < 216; ++code)
    rows.push_back(
        {1000 + 3 * code, 1.98 * R * Vec3(code / 36, code / 6 % 6, code % 6) + random.vector(0.02 * R)});
  return rows;
}

std::filesystem::path write(const io::TemporaryFolder& folder, const char* name,
                            const std::vector<Row>& rows) {
  std::string text = "id,x [um],y [um],z [um],radius [um]\n";
  for (const Row& row : rows)
    text += fmt::format("{},{},{},{},5\n", row.id, row.x.x() * 1e6, row.x.y() * 1e6, row.x.z() * 1e6);
  folder.write(name, text);
  return folder / name;
}

// Shrunken by 5 %, turned, moved, and in another order of rows.
std::vector<Row> shrunken(std::vector<Row> rows) {
  for (Row& row : rows) row.x = 0.95 * observe::samples::some_rotation() * row.x + Vec3(1e-4, 0.0, -3e-4);
  std::reverse(rows.begin(), rows.end());
  return rows;
}

std::vector<std::string> faults_of(const Centres& centres) {
  try {
    read_centres(centres);
  } catch (const InputError& error) {
    return error.faults();
  }
  return {};
}

TEST(Centres, OfUniformShrinkageShowNoRearrangement) {
  const io::TemporaryFolder folder;
  Centres centres;
  centres.files = {write(folder, "a.csv", lattice()), write(folder, "b.csv", shrunken(lattice()))};
  const auto findings = analyze_centres(centres, "");
  const observe::Row& row = findings[1].row;
  EXPECT_NEAR(observe::value_of(row, "linear_strain_x"), std::log(0.95), 1e-9);
  EXPECT_NEAR(observe::value_of(row, "rearrangement_deviation_mean"), 0.0, 1e-9);
  EXPECT_NEAR(observe::value_of(row, "rearrangement_pair_ratio"), 0.0, 1e-7);
  EXPECT_NEAR(observe::value_of(row, "relative_density") * std::pow(0.95, 3),
              observe::value_of(findings[0].row, "relative_density"), 1e-9);
  for (const char* unknown : {"time [s]", "temperature [K]", "contacts_thinning", "rolling_mean [rad]",
                              "rotation_mean [rad]", "neck_ratio_mean", "non_affine_share", "sliding_mean"}) {
    EXPECT_TRUE(std::isnan(observe::value_of(row, unknown))) << unknown;
  }
}

TEST(Centres, OneDisplacedParticleGivesTheValueByHand) {
  const io::TemporaryFolder folder;
  std::vector<Row> moved = lattice();
  moved[100].x += Vec3(0.3 * R, 0.0, 0.0);
  Centres centres;
  centres.files = {write(folder, "a.csv", lattice()), write(folder, "b.csv", moved)};
  centres.times = {0.0, 3600.0};
  const auto findings = analyze_centres(centres, "");
  // All but the share of the best affine motion that follows it: 0.3 on one of 216.
  EXPECT_NEAR(observe::value_of(findings[1].row, "rearrangement_deviation_mean"), 0.3 / 216.0,
              0.3 * 0.3 / 216.0 * 10);
  EXPECT_LT(observe::value_of(findings[1].row, "rearrangement_deviation_q50"), 0.01);
  EXPECT_EQ(observe::value_of(findings[1].row, "time [s]"), 3600.0);
  const auto backwards = analyze_centres(centres, "1");
  EXPECT_EQ(observe::value_of(backwards[1].row, "rearrangement_deviation_q90"), 0.0);
  EXPECT_GT(observe::value_of(backwards[0].row, "rearrangement_deviation_mean"), 0.001);
}

TEST(Centres, AreInContactWhereTheyTouchOrWithinTheGap) {
  const io::TemporaryFolder folder;
  std::vector<Row> row_of_three;
  for (int n = 0; n < 3; ++n) row_of_three.push_back({n, Vec3(n == 2 ? 4.03 * R : n * 1.99 * R, 0.0, 0.0)});
  Centres centres;
  centres.files = {write(folder, "a.csv", row_of_three), write(folder, "b.csv", row_of_three)};
  EXPECT_EQ(read_centres(centres)[0].state.contacts.size(), 1U);
  centres.gap = 0.05;
  EXPECT_EQ(read_centres(centres)[0].state.contacts.size(), 2U);
}

TEST(Centres, TakeTheContactsOfAFileByItsRows) {
  const io::TemporaryFolder folder;
  std::vector<Row> rows = lattice();
  std::reverse(rows.begin(), rows.end());  // row 0 has the largest id
  Centres centres;
  centres.files = {write(folder, "a.csv", rows), write(folder, "b.csv", rows)};
  folder.write("contacts.csv", "i,j,neck_radius [um]\n0,1,2\n215,3,1\n");
  centres.contacts = {folder / "contacts.csv", folder / "contacts.csv"};
  const Moment moment = read_centres(centres)[0];
  EXPECT_EQ(moment.state.contacts.i, (std::vector<std::int32_t>{0, 214}));
  EXPECT_EQ(moment.state.contacts.j, (std::vector<std::int32_t>{212, 215}));
  ASSERT_EQ(moment.necks.neck_radius.size(), 2U);
  EXPECT_NEAR(moment.necks.neck_radius[0], 1e-6, 1e-18);
  const auto findings = analyze_centres(centres, "");
  EXPECT_NEAR(observe::value_of(findings[0].row, "neck_ratio_mean"), 0.3, 1e-12);
}

TEST(Centres, WithLostParticlesAreRefusedUnlessOnlyTheCommonCount) {
  const io::TemporaryFolder folder;
  std::vector<Row> fewer = lattice();
  fewer.erase(fewer.begin() + 7);
  fewer.push_back({5, Vec3(1e-3, 0.0, 0.0)});
  Centres centres;
  centres.files = {write(folder, "a.csv", lattice()), write(folder, "b.csv", fewer)};
  const auto faults = faults_of(centres);
  EXPECT_TRUE(mentions(faults, {"b.csv", "lacks 1 of the 216", "1021"}));
  EXPECT_TRUE(mentions(faults, {"a.csv", "lacks 1 of the 216", "(ids 5)"}));
  EXPECT_TRUE(mentions(faults, {"--common"}));
  centres.common_only = true;
  const auto moments = read_centres(centres);
  for (const Moment& moment : moments) EXPECT_EQ(moment.state.particles.size(), 215U);
  EXPECT_LT(moments[0].state.contacts.size(), moments[0].state.particles.size() * 3);
  EXPECT_EQ(moments[0].state.contacts.size(), moments[1].state.contacts.size());
  const Contacts& contacts = moments[0].state.contacts;
  EXPECT_EQ(contacts.rolling_path.size(), contacts.size());
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    ASSERT_LT(contacts.j[k], 215);
    const auto& x = moments[0].state.particles.position;
    EXPECT_LT((x[contacts.j[k]] - x[contacts.i[k]]).norm(), 2.0 * R);
  }
}

TEST(Centres, TellAllFaultsTogether) {
  const io::TemporaryFolder folder;
  Centres centres;
  centres.files = {folder / "missing.csv"};
  centres.times = {1.0, 0.0};
  centres.contacts = {"a.csv", "b.csv"};
  const auto faults = faults_of(centres);
  EXPECT_TRUE(mentions(faults, {"--centres", "two times"}));
  EXPECT_TRUE(mentions(faults, {"--times", "2 given for 1"}));
  EXPECT_TRUE(mentions(faults, {"--times", "ascend"}));
  EXPECT_TRUE(mentions(faults, {"--contacts", "2 given for 1"}));
  folder.write("bad.csv", "x,y,z\n0,0,0\n");
  const auto bad = faults_of({{folder / "bad.csv", folder / "missing.csv"}, {}, {}});
  EXPECT_TRUE(mentions(bad, {"bad.csv", "radius"}));
  EXPECT_TRUE(mentions(bad, {"missing.csv"}));
}

}  // namespace
}  // namespace frit::analyze
