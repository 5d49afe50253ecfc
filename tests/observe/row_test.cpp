#include "observe/row.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "core/error.hpp"
#include "core/parallel.hpp"
#include "observe/fields.hpp"
#include "observe/samples.hpp"

namespace frit::observe {
namespace {

// A shrunken, stirred lattice with everything set that a row looks at.
struct Sample {
  Reference reference;
  State state;
  std::vector<double> neck_radius, normal_resistance, sliding_resistance;

  explicit Sample(const samples::Lattice& lattice) : state(samples::make_lattice(lattice)) {
    reference = take_reference(state);
    samples::Random random(31);
    samples::move_affinely(state, 0.93 * Mat3::Identity());
    for (Vec3& x : state.particles.position) x += random.vector(0.1 * samples::radius);
    for (Vec3& velocity : state.particles.velocity) velocity = random.vector(1e-8);
    samples::touch_all(state);
    for (std::size_t k = 0; k < state.contacts.size(); ++k) {
      state.contacts.approach_velocity[k] = random.between(-1e-9, 1e-8);
      state.contacts.sliding_velocity[k] = random.vector(1e-9);
      neck_radius.push_back(random.between(0.1, 0.5) * samples::radius);
      normal_resistance.push_back(random.between(1.0, 2.0));
      sliding_resistance.push_back(random.between(0.1, 0.2));
    }
    state.time = 12.0;
    state.temperature = 1323.15;
    state.theta = 3e-27;
    state.cell_strain = Vec3(-0.1, -0.2, -0.3);
  }
  NeckLaw law() const { return {neck_radius, normal_resistance, sliding_resistance}; }
  Row row() const { return observe_row(reference, state, law()); }
};

TEST(ObserveRow, HasTheColumnsOfTheContractInOrder) {
  const std::vector<std::string> expected{"time [s]",
                                          "temperature [K]",
                                          "relative_density",
                                          "union_density",
                                          "coordination",
                                          "rattlers",
                                          "contacts",
                                          "neck_ratio_mean",
                                          "neck_ratio_q10",
                                          "neck_ratio_q50",
                                          "neck_ratio_q90",
                                          "linear_strain_x",
                                          "linear_strain_y",
                                          "linear_strain_z",
                                          "theta [m^5 s/(N s)]",
                                          "rearrangement_deviation_mean"};
  const Row row = Sample({.edge = 3, .jitter = 0.05, .periodic = true}).row();
  ASSERT_EQ(row.size(), 56u);
  for (std::size_t n = 0; n < expected.size(); ++n) EXPECT_EQ(row[n].name, expected[n]);
}

TEST(ObserveRow, CopiesTheClockAndTheCell) {
  const Row row = Sample({.edge = 3, .periodic = true}).row();
  EXPECT_EQ(value_of(row, "time [s]"), 12.0);
  EXPECT_EQ(value_of(row, "temperature [K]"), 1323.15);
  EXPECT_EQ(value_of(row, "theta [m^5 s/(N s)]"), 3e-27);
  EXPECT_EQ(value_of(row, "linear_strain_z"), -0.3);
  EXPECT_THROW(value_of(row, "no_such_column"), ContractError);
}

TEST(ObserveRow, HasAValueInEveryColumnOfALargeEnoughPacking) {
  for (const bool periodic : {false, true}) {
    for (const Column& column : Sample({.edge = 7, .jitter = 0.05, .periodic = periodic}).row()) {
      EXPECT_TRUE(std::isfinite(column.value)) << column.name << (periodic ? ", periodic" : ", free");
    }
  }
}

TEST(ObserveRow, HasTheSameNamesForTwoSpheresOfWhichLittleIsKnown) {
  State state;
  state.particles.add(Vec3::Zero(), samples::radius);
  state.particles.add(Vec3(1.9 * samples::radius, 0.0, 0.0), samples::radius);
  samples::touch_all(state);
  const Row row = observe_row(take_reference(state), state, {});
  const Row full = Sample({.edge = 3}).row();
  ASSERT_EQ(row.size(), full.size());
  for (std::size_t n = 0; n < row.size(); ++n) EXPECT_EQ(row[n].name, full[n].name);
  EXPECT_EQ(value_of(row, "coordination"), 1.0);
  EXPECT_TRUE(std::isnan(value_of(row, "relative_density")));
  EXPECT_TRUE(std::isnan(value_of(row, "linear_strain_x")));
}

TEST(ObserveRow, GivesTheSameBitsForAnyNumberOfThreads) {
  const Sample sample({.edge = 13, .jitter = 0.05});  // more than two blocks of particles
  const int before = threads();
  set_threads(1);
  const Row one = sample.row();
  set_threads(3);
  const Row three = sample.row();
  set_threads(before);
  for (std::size_t n = 0; n < one.size(); ++n) {
    EXPECT_EQ(std::bit_cast<std::uint64_t>(one[n].value), std::bit_cast<std::uint64_t>(three[n].value))
        << one[n].name;
  }
}

TEST(ObserveRow, DoesNotDependOnTheInternalOrder) {
  const Sample sample({.edge = 7, .jitter = 0.05});
  const Row straight = sample.row();
  const Row shuffled = observe_row(sample.reference, samples::shuffle(sample.state, 5).first, sample.law());
  for (std::size_t n = 0; n < straight.size(); ++n) {
    EXPECT_NEAR(shuffled[n].value, straight[n].value, 1e-12 * std::abs(straight[n].value))
        << straight[n].name;
  }
}

TEST(Fields, HoldOneEntryForEachParticleAndContact) {
  const Sample sample({.edge = 3});
  for (const Field& field : particle_fields(sample.reference, sample.state)) {
    EXPECT_EQ(field.values.size(), 27u * field.components) << field.name;
  }
  const auto fields = contact_fields(sample.state, sample.law());
  for (const Field& field : fields) {
    EXPECT_EQ(field.values.size(), sample.state.contacts.size() * field.components) << field.name;
  }
  EXPECT_EQ(fields.back().name, "sliding_resistance [N s/m]");
  EXPECT_EQ(contact_fields(sample.state, {}).size() + 4, fields.size());
}

TEST(Fields, GiveTheRotationAsAxisTimesAngle) {
  Sample sample({.edge = 3});
  auto& orientation = sample.state.particles.orientation;
  orientation[1] = Eigen::AngleAxisd(0.3, Vec3::UnitY());
  orientation[2].coeffs() = -orientation[1].coeffs();  // the same turn
  orientation[3] = Eigen::AngleAxisd(3.5, Vec3::UnitX());
  const Field rotation = particle_fields(sample.reference, sample.state)[1];
  ASSERT_EQ(rotation.name, "rotation [rad]");
  EXPECT_EQ(rotation.values[0], 0.0);
  EXPECT_NEAR(rotation.values[3 * 1 + 1], 0.3, 1e-15);
  EXPECT_NEAR(rotation.values[3 * 2 + 1], 0.3, 1e-15);
  EXPECT_NEAR(rotation.values[3 * 3], 3.5 - 2.0 * std::acos(-1.0), 1e-14);
}

TEST(Fields, AgeCountsFromBirth) {
  Sample sample({.edge = 3});
  sample.state.contacts.birth_time[4] = 5.0;
  const Field age = contact_fields(sample.state, {})[1];
  ASSERT_EQ(age.name, "age [s]");
  EXPECT_EQ(age.values[4], 7.0);
  EXPECT_EQ(age.values[3], 12.0);
}

}  // namespace
}  // namespace frit::observe
