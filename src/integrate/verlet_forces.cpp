#include "integrate/verlet_forces.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/parallel.hpp"

namespace frit::integrate {
namespace {

using Lane = Lanes<double>;

// Forces on particle i of a pair, and the torques of sliding on both for arms of one.
struct Action {
  Lane force, torque, bending, separation;
  double arm_i, arm_j;
  double normal, approach_velocity, pull, whole_pull;
  Lane sliding_velocity, sliding_power, bending_power;  // powers: the sum of the lanes counts
};

// Two particles as a neck sees them.
struct Ends {
  const VerletBody& i;
  const VerletBody& j;
  Lane separation;  // [m], from i to j
  double distance;  // [m]
};

// Resistances over q^2 of the moment: theory.md, section 7.
template <bool has_bending>
inline Action act(const contact::SmoothLaw& law, const VerletPair& pair, const Ends& ends,
                  const VerletMoment& moment) {
  Action done;
  const double raw = pair.growth * (pair.sum_radii - ends.distance) + pair.offset;
  const double q = std::clamp(raw, 0.0, pair.cap), mobility = 1.0 / moment.delta_b;
  const Lane n = ends.separation * (1.0 / ends.distance);
  const Lane apart = ends.i.v - ends.j.v - moment.rate * ends.separation;
  done.arm_i = pair.arm_share * ends.distance;
  done.arm_j = ends.distance - done.arm_i;
  const double approach = dot(n, apart)[0];
  const Lane contact_velocity = apart + cross(done.arm_i * ends.i.w + done.arm_j * ends.j.w, n);
  const double viscous = q * mobility, equivalent = 0.5 * pair.growth;
  done.whole_pull = pair.least_pull;
  if (law.pull_per_radius != 0.0) done.whole_pull += law.pull_per_radius * std::sqrt(q);
  done.pull = done.whole_pull;
  if (raw > (1.0 - contact::equilibrium_width) * pair.cap)
    done.pull *= contact::attraction_share(raw, pair.cap);
  done.approach_velocity = approach;
  done.normal = contact::smooth_normal_force(law.normal * q * viscous, approach, done.pull, law.opens_freely);
  done.sliding_velocity = contact_velocity - approach * n;
  const Lane slide = (law.sliding * viscous * equivalent * equivalent) * done.sliding_velocity;
  done.force = -done.normal * n - slide;
  done.torque = cross(slide, n);
  done.separation = ends.separation;
  done.sliding_power = slide * done.sliding_velocity;
  if constexpr (has_bending) {
    const Lane turn = ends.i.w - ends.j.w, along = dot(turn, n) * n;
    done.bending = (law.rolling * q * q * viscous) * (turn - along) +
                   (law.twisting * q * viscous * equivalent * equivalent) * along;
    done.bending_power = done.bending * turn;
  }
  return done;
}

}  // namespace

VerletForces::VerletForces(const contact::SinteringLaw& law, VerletList& list, std::vector<VerletBody> bodies,
                           std::vector<VerletInertia> inertia)
    : law_(contact::smooth_law_of(law)),
      has_bending_(law.neck_bending),
      list_(list),
      bodies_(std::move(bodies)),
      next_(bodies_.size()),
      inertia_(std::move(inertia)),
      turn_(bodies_.size(), Lane{}),
      shifts_(list.images().size(), Lane{}),
      of_block_(list.blocks(), PairSums{}),
      sums_(list.blocks() * (block_size + 1)) {}

void VerletForces::set_shifts(Lane size) {
  for (std::size_t n = 0; n < shifts_.size(); ++n) {
    const Image& image = list_.images()[n];
    shifts_[n] = Lane{image[0] * size[0], image[1] * size[1], image[2] * size[2], 0.0};
  }
}

template <bool has_bending>
PairSums VerletForces::sweep_block(std::size_t block, const VerletMoment& moment) {
  Sums* const sums = sums_.data() + block * (block_size + 1);
  std::fill_n(sums, block_size + 1, Sums{});
  PairSums all{};
  for (VerletPair& pair : list_.pairs(block)) {
    const VerletBody &i = bodies_[pair.i], &j = bodies_[pair.j];
    const Lane d = j.x + shifts_[pair.image] - i.x;
    const Ends ends{i, j, d, std::sqrt(dot(d, d)[0])};
    if (pair.kind == PairKind::gap) [[unlikely]] {
      const double overlap = pair.sum_radii - ends.distance;
      if (overlap < pair.offset) continue;
      list_.give_birth(pair, overlap, moment.time);
    }
    const Action action = act<has_bending>(law_, pair, ends, moment);
    Sums &of_i = sums[pair.slot_i], &of_j = sums[pair.slot_j];
    of_i.force += action.force;
    of_i.torque += action.arm_i * action.torque;
    of_j.force -= action.force;
    of_j.torque += action.arm_j * action.torque;
    if constexpr (has_bending) {
      of_i.torque -= action.bending;
      of_j.torque += action.bending;
    }
    const double share = static_cast<double>(pair.is_owner);
    all.virial += share * (action.force * d);
    all.sliding += share * action.sliding_power;
    if constexpr (has_bending) all.bending += share * action.bending_power;
    const double approach = share * action.approach_velocity;
    all.released += action.pull * approach;
    all.approach += (action.normal + action.pull) * approach;
  }
  return all;
}

void VerletForces::move_block(std::size_t block, const VerletMoment& moment) {
  const std::size_t begin = block * block_size, end = std::min(bodies_.size(), begin + block_size);
  const Sums* const sums = sums_.data() + block * (block_size + 1);
  for (std::size_t n = begin; n < end; ++n) {
    const VerletBody& body = bodies_[n];
    VerletBody& moved = next_[n];
    const VerletInertia& own = inertia_[n];
    const Sums& sum = sums[n - begin];
    moved.v = body.v + moment.dt * (own.inverse_mass * sum.force + own.push);
    moved.w = body.w + (moment.dt * own.inverse_moment) * sum.torque;
    moved.x = body.x + moment.dt * (moved.v + moment.rate * body.x);
    turn_[n] += moment.dt * moved.w;
  }
}

PairSums VerletForces::step(const VerletMoment& moment) {
  set_shifts(moment.size);
  parallel_blocks(bodies_.size(), [&](std::size_t begin, std::size_t) {
    const std::size_t block = begin / block_size;
    of_block_[block] = has_bending_ ? sweep_block<true>(block, moment) : sweep_block<false>(block, moment);
    move_block(block, moment);
  });
  std::swap(bodies_, next_);
  PairSums all{};
  for (const PairSums& part : of_block_) {
    all.virial += part.virial;
    all.sliding += part.sliding;
    all.bending += part.bending;
    all.released += part.released;
    all.approach += part.approach;
  }
  return all;
}

PairForces VerletForces::forces_of(const VerletPair& pair, const VerletMoment& moment) const {
  const VerletBody &i = bodies_[pair.i], &j = bodies_[pair.j];
  const Lane d = j.x + shifts_[pair.image] - i.x;
  const Action action = act<false>(law_, pair, {i, j, d, std::sqrt(dot(d, d)[0])}, moment);
  return {action.normal, action.approach_velocity, action.pull, action.whole_pull, action.sliding_velocity};
}

NeckPaths VerletForces::path_rates(const VerletPair& pair, const VerletMoment& moment) const {
  const VerletBody &i = bodies_[pair.i], &j = bodies_[pair.j];
  const Vec3 normal = to_vec3(j.x + shifts_[pair.image] - i.x).normalized(), spin = to_vec3(j.w - i.w);
  const double twist = spin.dot(normal);
  const double sliding = to_vec3(forces_of(pair, moment).sliding_velocity).norm();
  return {(spin - twist * normal).norm(), std::abs(twist), sliding};
}

}  // namespace frit::integrate
