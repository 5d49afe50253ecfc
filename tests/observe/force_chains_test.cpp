#include "observe/force_chains.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "observe/network_row.hpp"
#include "observe/particle_stress.hpp"
#include "observe/samples.hpp"

namespace frit::observe {
namespace {

// A 3 x 3 x 5 lattice with open columns of 5 along z; the columns in `loaded` carry a force.
State with_loaded_columns(const std::vector<int>& loaded, double force) {
  State state;
  for (int code = 0; code < 45; ++code)
    state.particles.add(1.9 * samples::radius * Vec3(code / 15, code / 5 % 3, code % 5), samples::radius);
  samples::touch_all(state);
  for (std::size_t k = 0; k < state.contacts.size(); ++k) {
    const bool is_upright = state.contacts.j[k] == state.contacts.i[k] + 1;
    for (const int column : loaded)
      if (is_upright && state.contacts.i[k] / 5 == column) state.contacts.normal_force[k] = force;
  }
  return state;
}

TEST(ForceChains, AreTheLoadedColumns) {
  const State state = with_loaded_columns({0, 4}, 1e-4);
  const auto stresses = particle_stresses(state, {});
  const ForceChains chains = find_force_chains(state, stresses, Load::compression);
  EXPECT_EQ(chains.sizes, (std::vector<double>{5.0, 5.0}));
  EXPECT_DOUBLE_EQ(chains.particle_share, 10.0 / 45.0);
  EXPECT_TRUE(find_force_chains(state, stresses, Load::tension).sizes.empty());
}

TEST(ForceChains, OfNeighbouringColumnsAreNotJoinedAcrossTheLoad) {
  const State state = with_loaded_columns({0, 1}, -1e-4);
  const ForceChains chains = find_force_chains(state, particle_stresses(state, {}), Load::tension);
  EXPECT_EQ(chains.sizes, (std::vector<double>{5.0, 5.0}));
}

TEST(ForceChains, EndWhereTheDirectionTurnsByMoreThanTheAngle) {
  // A bent row: the load comes along x, and goes on at a right angle along y.
  State state;
  for (const Vec3& place :
       {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(3, 0, 0), Vec3(3, 1, 0), Vec3(3, 2, 0)})
    state.particles.add(1.9 * samples::radius * place, samples::radius);
  samples::touch_all(state);
  ASSERT_EQ(state.contacts.size(), 5u);
  state.contacts.normal_force = {1e-4, 1e-4, 1e-4, 0.8e-4, 0.8e-4};
  for (std::size_t n = 0; n < 40; ++n)  // idle ones, that keep the mean low
    state.particles.add(Vec3(1.0, static_cast<double>(n), 0.0), samples::radius);
  const ForceChains chains = find_force_chains(state, particle_stresses(state, {}), Load::compression);
  EXPECT_EQ(chains.sizes, (std::vector<double>{4.0}));  // the corner is loaded along x more than along y
}

TEST(ForceChains, OfTwoParticlesAreNone) {
  State state;
  state.particles.add(Vec3::Zero(), samples::radius);
  state.particles.add(Vec3(1.9 * samples::radius, 0, 0), samples::radius);
  samples::touch_all(state);
  state.contacts.normal_force[0] = 1.0;
  for (int n = 0; n < 9; ++n) state.particles.add(Vec3(1.0 + n, 0, 0), samples::radius);
  EXPECT_TRUE(find_force_chains(state, particle_stresses(state, {}), Load::compression).sizes.empty());
}

TEST(NetworkRow, HasTheSameColumnsWithAndWithoutForces) {
  State state = with_loaded_columns({0}, 1e-4);
  const Row loaded = observe_network(state, {}, 0.6);
  std::fill(state.contacts.normal_force.begin(), state.contacts.normal_force.end(), 0.0);
  const Row idle = observe_network(state, {}, 0.6);
  ASSERT_EQ(loaded.size(), idle.size());
  for (std::size_t n = 0; n < idle.size(); ++n) EXPECT_EQ(loaded[n].name, idle[n].name);
  EXPECT_EQ(value_of(loaded, "compression_chains"), 1.0);
  EXPECT_EQ(value_of(loaded, "contacts_pulled"), 0.0);
  EXPECT_TRUE(std::isnan(value_of(idle, "compression_chains")));
  EXPECT_TRUE(std::isnan(value_of(idle, "mean_stress_zz [Pa]")));
  EXPECT_EQ(value_of(idle, "clustering"), 0.0);  // a cubic lattice has no triangles
}

}  // namespace
}  // namespace frit::observe
