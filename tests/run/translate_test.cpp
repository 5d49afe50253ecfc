#include "run/translate.hpp"

#include <gtest/gtest.h>

#include "integrate/temperature.hpp"
#include "run/samples.hpp"

namespace frit::run {
namespace {

using samples::pair_case;

TEST(Translate, EveryWordOfTheContactReachesTheLaw) {
  const io::TemporaryFolder folder;
  const auto law =
      step_settings_of(pair_case(folder, {"contact.attraction=parhami-mcmeeking", "contact.pull=unilateral",
                                          "contact.neck_bending=true", "contact.equilibrium_radius=smaller",
                                          "contact.sliding_resistance=0.2", "contact.birth_neck_ratio=0.04"}))
          .law;
  EXPECT_EQ(law.attraction, contact::Attraction::parhami_mcmeeking);
  EXPECT_EQ(law.pull, contact::Pull::unilateral);
  EXPECT_EQ(law.equilibrium_radius, contact::EquilibriumRadius::smaller);
  EXPECT_TRUE(law.neck_bending);
  EXPECT_EQ(law.sliding_resistance, 0.2);
  EXPECT_EQ(law.birth_neck_ratio, 0.04);
  EXPECT_EQ(law.surface_energy, 1.72);
  EXPECT_NEAR(law.dihedral_angle, 146.0 * pi / 180.0, 1e-12);
}

TEST(Translate, DefaultsAreThePapersLaw) {
  const io::TemporaryFolder folder;
  const auto settings = step_settings_of(pair_case(folder));
  EXPECT_EQ(settings.law.attraction, contact::Attraction::bouvard_mcmeeking);
  EXPECT_EQ(settings.law.pull, contact::Pull::bilateral);
  EXPECT_EQ(settings.law.closing, contact::Closing::viscous);
  EXPECT_EQ(settings.inertia, network::Inertia::overdamped);
  EXPECT_EQ(settings.freedom, network::Freedom::particles);
  EXPECT_EQ(settings.solver, integrate::Solver::conjugate_gradients);
  EXPECT_FALSE(settings.spins_blocked);
  EXPECT_TRUE(settings.error_controls_step);
}

TEST(Translate, MethodWordsChooseInertiaFreedomAndSolver) {
  const io::TemporaryFolder folder;
  const auto settings = step_settings_of(
      pair_case(folder, {"method.name=mean-field", "method.inertia=dynamic", "method.solver=gauss-seidel",
                         "contact.spins=blocked", "method.time_step=2"}));
  EXPECT_EQ(settings.freedom, network::Freedom::affine);
  EXPECT_EQ(settings.inertia, network::Inertia::dynamic);
  EXPECT_EQ(settings.solver, integrate::Solver::gauss_seidel);
  EXPECT_TRUE(settings.spins_blocked);
  EXPECT_FALSE(settings.error_controls_step);
}

TEST(Translate, AnAutomaticToleranceFollowsTheAccuracyButIsNeverLoose) {
  const io::TemporaryFolder folder;
  const auto tolerance = [&](const std::vector<std::string>& overrides) {
    return step_settings_of(pair_case(folder, overrides)).tolerance;
  };
  EXPECT_DOUBLE_EQ(tolerance({"method.accuracy=0.001"}), 5e-6);
  EXPECT_DOUBLE_EQ(tolerance({"method.accuracy=0.1"}), 5e-5);
  EXPECT_DOUBLE_EQ(tolerance({"method.tolerance=1e-3"}), 1e-3);
}

TEST(Translate, RampsAndHoldsBecomeTheFurnace) {
  const io::TemporaryFolder folder;
  const Heating heating = heating_of(
      pair_case(folder, {"temperature.start=300 K",
                         "temperature.program=[{rate = 2, to = 900}, {hold = 60}, {rate = 1, to = 850}]"}));
  const integrate::Furnace furnace(heating.diffusion, heating.start, heating.ramps);
  EXPECT_EQ(heating.ramp_ends, (std::vector<double>{300.0, 360.0, 410.0}));
  EXPECT_EQ(heating.hottest, 900.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(150.0), 600.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(330.0), 900.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(385.0), 875.0);
  EXPECT_DOUBLE_EQ(furnace.temperature(1e6), 850.0);
}

TEST(Translate, ARampToWhereItStartsTakesNoTime) {
  const io::TemporaryFolder folder;
  const Heating heating = heating_of(pair_case(
      folder, {"temperature.start=300", "temperature.program=[{rate = 2, to = 300}, {hold = 60}]"}));
  EXPECT_EQ(heating.ramp_ends, std::vector<double>{60.0});
}

TEST(Translate, DiffusionOfCopperIsThatOfTheNotation) {
  const io::TemporaryFolder folder;
  EXPECT_NEAR(heating_of(pair_case(folder)).diffusion.delta_b(1323.15) / 2.37e-28, 1.0, 2e-3);
}

}  // namespace
}  // namespace frit::run
