#include "run/id_order.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <random>
#include <set>
#include <tuple>

#include "observe/samples.hpp"
#include "run/morton.hpp"

namespace frit::run {
namespace {

// A random periodic state whose contacts carry marks that tell their pair.
State marked_state() {
  observe::samples::Random random(3);
  State state;
  state.cell = {true, Vec3::Constant(1e-4)};
  for (int n = 0; n < 40; ++n) state.particles.add(random.vector(5e-5), 5e-6);
  std::shuffle(state.particles.id.begin(), state.particles.id.end(), std::minstd_rand(5));
  for (std::int32_t i = 0; i < 39; ++i) {
    const std::int32_t j = i + 1;
    observe::samples::add_contact(state, i, j, {static_cast<std::int8_t>(i % 2), 0, -1});
    const std::size_t k = state.contacts.size() - 1;
    state.contacts.birth_time[k] = static_cast<double>(i);
    state.contacts.rolling_path[k] = 1.0 + i;
    state.contacts.twisting_path[k] = 2.0 + i;
    state.contacts.sliding_path[k] = 3.0 + i;
    state.contacts.sliding_velocity[k] =
        state.cell.separation(state.particles.position[static_cast<std::size_t>(i)],
                              state.particles.position[static_cast<std::size_t>(j)], state.contacts.image[k]);
    state.cracks.add(i, j, {0, 1, 0}, static_cast<double>(i));
  }
  return state;
}

TEST(IdOrder, ParticlesAscendAndContactsAreSorted) {
  const State ordered = in_id_order(marked_state());
  EXPECT_TRUE(std::is_sorted(ordered.particles.id.begin(), ordered.particles.id.end()));
  const Contacts& contacts = ordered.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    EXPECT_LE(contacts.i[k], contacts.j[k]);
    if (k == 0) continue;
    EXPECT_LT(std::tie(contacts.i[k - 1], contacts.j[k - 1], contacts.image[k - 1]),
              std::tie(contacts.i[k], contacts.j[k], contacts.image[k]));
  }
}

// The sliding velocity was set to the separation, which changes sign with the order of the pair.
TEST(IdOrder, APairThatChangesSidesKeepsItsGeometry) {
  const State ordered = in_id_order(marked_state());
  for (std::size_t k = 0; k < ordered.contacts.size(); ++k) {
    const auto i = static_cast<std::size_t>(ordered.contacts.i[k]),
               j = static_cast<std::size_t>(ordered.contacts.j[k]);
    const Vec3 apart = ordered.cell.separation(ordered.particles.position[i], ordered.particles.position[j],
                                               ordered.contacts.image[k]);
    EXPECT_LT((apart - ordered.contacts.sliding_velocity[k]).norm(), 1e-18);
  }
}

TEST(IdOrder, ContactsAndCracksStayWithTheirPair) {
  const State state = marked_state(), ordered = in_id_order(state);
  using Tagged = std::tuple<std::int64_t, std::int64_t, double>;
  const auto tagged = [](const State& s, const auto& pairs, const std::vector<double>& mark) {
    std::set<Tagged> all;
    for (std::size_t k = 0; k < pairs.size(); ++k) {
      const auto [low, high] = std::minmax(s.particles.id[static_cast<std::size_t>(pairs.i[k])],
                                           s.particles.id[static_cast<std::size_t>(pairs.j[k])]);
      all.insert({low, high, mark[k]});
    }
    return all;
  };
  EXPECT_EQ(tagged(state, state.contacts, state.contacts.birth_time),
            tagged(ordered, ordered.contacts, ordered.contacts.birth_time));
  for (const auto path : {&Contacts::rolling_path, &Contacts::twisting_path, &Contacts::sliding_path}) {
    EXPECT_EQ(tagged(state, state.contacts, state.contacts.*path),
              tagged(ordered, ordered.contacts, ordered.contacts.*path));
  }
  EXPECT_EQ(tagged(state, state.cracks, state.cracks.overlap_when_parted),
            tagged(ordered, ordered.cracks, ordered.cracks.overlap_when_parted));
}

TEST(IdOrder, TheInternalOrderDoesNotShow) {
  const State state = marked_state(), once = in_id_order(state), twice = in_id_order(once);
  EXPECT_EQ(once.particles.id, twice.particles.id);
  EXPECT_EQ(once.contacts.i, twice.contacts.i);
  EXPECT_EQ(once.contacts.image, twice.contacts.image);
  EXPECT_EQ(once.contacts.sliding_velocity, twice.contacts.sliding_velocity);
}

}  // namespace
}  // namespace frit::run
