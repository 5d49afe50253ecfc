#include "integrate/verlet_step.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "integrate/stable_step.hpp"

namespace frit::integrate {
namespace {

using Lane = Lanes<double>;

constexpr double skin_share = 0.05;  // of the smallest radius
// Of the limit of stability. The limit is a bound, and necks grow between two looks at it.
constexpr double safety = 0.8;
// The limit is looked at so often that it changes by about this share in between.
constexpr double looked_at_growth = 0.02;
constexpr std::int64_t most_steps_between_limits = 4096, most_steps_between_looks = 64;
// An attempt is no longer than these, about half a second, so that a run can be stopped.
constexpr std::int64_t most_particle_steps = 4'000'000, most_steps = 200'000, least_steps = 256;
constexpr std::int64_t particle_steps_between_asking = 100'000;  // whether to go on
// Velocities that would carry a particle so far [mean radii] in one step are no motion of a powder.
constexpr double runaway = 0.1;

constexpr double infinity = std::numeric_limits<double>::infinity();

// The fastest of anything, to know how long a list stays good.
struct Fastest {
  double speed = 0.0, moved = 0.0, turning = 0.0;  // [m/s], [m], [1/s]
};

class Run {
 public:
  Run(const VerletSettings& settings, const Furnace& furnace, const State& from);

  StepReport until(const Stretch& stretch, const solve::Abandon& abandon);
  contact::ContactChanges write_to(State& to);

 private:
  double duration_left(double duration) const { return duration - elapsed_; }
  double time() const { return from_.time + elapsed_; }
  double next_duration(double left);
  void renew_limit();
  void step(double dt);
  void count_work(const PairSums& pairs, const Lane& of_cell);
  double kinetic_energy() const;
  double power_of_loads() const;
  bool look();
  void follow_paths();
  void limit_travel(double speed);
  Fastest fastest() const;
  void write_necks(State& to) const;

  const VerletSettings& settings_;
  const Furnace& furnace_;
  const State& from_;
  double mean_radius_, skin_, largest_diameter_;
  std::vector<VerletInertia> inertia_;
  VerletList list_;
  VerletForces forces_;
  std::vector<Lane> start_;  // places when the list was made
  VerletMoment moment_{};
  Lane axis_inverse_mass_{};
  bool is_driven_ = false;                       // the cell, by its stress
  double elapsed_ = 0.0, followed_until_ = 0.0;  // [s]
  std::int64_t steps_ = 0;
  double limit_rate_ = 0.0, limit_delta_b_ = 0.0;
  std::int64_t limit_due_ = 0, limit_interval_ = 1;
  std::int64_t look_due_ = 1, look_interval_ = 1;
  double travel_limit_ = 0.0;  // [s]
  Work work_;
  std::vector<std::size_t> loaded_;  // particles with an external force
  double load_power_ = 0.0;          // [W], now
};

// Rotation by a rotation vector [rad], small or not.
Quat turned(const Quat& orientation, const Vec3& turn) {
  const double angle = turn.norm();
  if (angle == 0.0) return orientation;
  return Quat(Eigen::AngleAxisd(angle, turn / angle)) * orientation;
}

std::vector<VerletBody> bodies_of(const State& state) {
  std::vector<VerletBody> bodies(state.particles.size());
  for (std::size_t n = 0; n < bodies.size(); ++n) {
    const Vec3& x = state.particles.position[n];
    Vec3 v = state.particles.velocity[n];
    if (state.cell.periodic) v -= state.cell_rate.cwiseProduct(x);
    bodies[n] = {lanes<double>(x), lanes<double>(v), lanes<double>(state.particles.spin[n])};
    if (state.particles.fixed[n] != 0) bodies[n].v = bodies[n].w = Lane{};
  }
  return bodies;
}

std::vector<VerletInertia> inertia_of(const VerletSettings& settings, const State& state) {
  const Particles& p = state.particles;
  std::vector<VerletInertia> inertia(p.size());
  for (std::size_t n = 0; n < p.size(); ++n) {
    const double mass = p.mass[n] * settings.density_factor;
    const bool moves = p.fixed[n] == 0, turns = moves && !settings.spins_blocked;
    inertia[n].inverse_mass = moves ? 1.0 / mass : 0.0;
    inertia[n].inverse_moment = turns ? 2.5 / (mass * p.radius[n] * p.radius[n]) : 0.0;
    inertia[n].push = inertia[n].inverse_mass * lanes<double>(p.force[n]);
  }
  return inertia;
}

Run::Run(const VerletSettings& settings, const Furnace& furnace, const State& from)
    : settings_(settings),
      furnace_(furnace),
      from_(from),
      mean_radius_(ordered_sum(from.particles.size(), 0.0,
                               [&](std::size_t begin, std::size_t end) {
                                 double sum = 0.0;
                                 for (std::size_t n = begin; n < end; ++n) sum += from.particles.radius[n];
                                 return sum;
                               }) /
                   static_cast<double>(from.particles.size())),
      skin_(skin_share * *std::min_element(from.particles.radius.begin(), from.particles.radius.end())),
      largest_diameter_(2.0 * *std::max_element(from.particles.radius.begin(), from.particles.radius.end())),
      inertia_(inertia_of(settings, from)),
      list_(from, settings.law, skin_),
      forces_(settings.law, list_, bodies_of(from), inertia_),
      is_driven_(from.cell.periodic && !settings.strain_rate) {
  for (const VerletBody& body : forces_.bodies()) start_.push_back(body.x);
  moment_.size = from.cell.periodic ? lanes<double>(from.cell.size) : Lane{};
  if (from.cell.periodic) moment_.rate = lanes<double>(from.cell_rate);
  limit_travel(fastest().speed);
  for (std::size_t n = 0; n < from.particles.size(); ++n) {
    if (!from.particles.force[n].isZero(0.0)) loaded_.push_back(n);
  }
  load_power_ = power_of_loads();
  if (!is_driven_) return;
  double mass = 0.0;
  for (const double own : from.particles.mass) mass += settings.density_factor * own;
  for (int axis = 0; axis < 3; ++axis) {
    axis_inverse_mass_[axis] =
        12.0 / (settings.cell_inertia * mass * from.cell.size[axis] * from.cell.size[axis]);
  }
}

void Run::renew_limit() {
  forces_.set_shifts(moment_.size);
  const double before = limit_rate_ * limit_delta_b_;
  limit_delta_b_ = furnace_.delta_b(time());
  limit_rate_ = largest_rate(list_, {settings_.law, forces_.bodies(), forces_.shifts(), inertia_,
                                     limit_delta_b_, axis_inverse_mass_});
  const double growth = before > 0.0 ? limit_rate_ * limit_delta_b_ / before - 1.0 : 1.0;
  const double wanted = looked_at_growth / std::max(growth, 1e-6);
  const double factor = std::clamp(wanted, 0.25, 2.0);
  limit_interval_ = std::clamp<std::int64_t>(
      static_cast<std::int64_t>(factor * static_cast<double>(limit_interval_)), 1, most_steps_between_limits);
  limit_due_ = steps_ + limit_interval_;
}

// The longest step that is allowed, or a little less to end at the duration.
double Run::next_duration(double left) {
  double dt = 0.0;
  if (settings_.time_step) {
    dt = *settings_.time_step;
  } else {
    if (steps_ >= limit_due_) renew_limit();
    // Resistances go with 1/Delta_b.
    const double rate = limit_rate_ * limit_delta_b_ / furnace_.delta_b(time());
    dt = std::min(2.0 * safety / rate, travel_limit_);
  }
  if (dt >= left) return left;
  return dt > 0.5 * left ? 0.5 * left : dt;
}

void Run::step(double dt) {
  moment_.dt = dt;
  moment_.time = time();
  moment_.delta_b = furnace_.delta_b(time());
  if (settings_.strain_rate) {
    for (int axis = 0; axis < 3; ++axis)
      moment_.rate[axis] = std::expm1((*settings_.strain_rate)[axis] * dt) / dt;
  }
  const PairSums pairs = forces_.step(moment_);
  const Lane rate_before = moment_.rate,
             pull = moment_.size[0] * moment_.size[1] * moment_.size[2] * lanes<double>(settings_.stress);
  if (from_.cell.periodic) {
    moment_.size += dt * (moment_.rate * moment_.size);
    moment_.rate += dt * (axis_inverse_mass_ * (pull - pairs.virial));
  }
  count_work(pairs, is_driven_ ? 0.5 * (rate_before + moment_.rate) * pull : rate_before * pairs.virial);
  ++steps_;
}

// Work of a step; `of_cell` is the power [W] of what drives the cell, by axes.
void Run::count_work(const PairSums& pairs, const Lane& of_cell) {
  const double dt = moment_.dt, power_before = load_power_;
  work_.released += dt * pairs.released;
  work_.approach += dt * pairs.approach;
  work_.sliding += dt * sum(pairs.sliding);
  work_.bending += dt * sum(pairs.bending);
  work_.cell += dt * (of_cell[0] + of_cell[1] + of_cell[2]);
  if (loaded_.empty()) return;
  load_power_ = power_of_loads();
  work_.load += 0.5 * dt * (power_before + load_power_);
}

double Run::power_of_loads() const {
  double power = 0.0;
  for (const std::size_t n : loaded_) {
    power += to_vec3(forces_.bodies()[n].v).dot(from_.particles.force[n]);
  }
  return power;
}

// Of the multiplied masses, against the motion with the cell, and of the cell's own inertia [J].
double Run::kinetic_energy() const {
  const auto half = [](double inverse, const Lane& rate) {
    return inverse > 0.0 ? 0.5 * dot(rate, rate)[0] / inverse : 0.0;
  };
  const std::span<const VerletBody> bodies = forces_.bodies();
  double energy = ordered_sum(bodies.size(), 0.0, [&](std::size_t begin, std::size_t end) {
    double sum = 0.0;
    for (std::size_t n = begin; n < end; ++n) {
      sum += half(inertia_[n].inverse_mass, bodies[n].v) + half(inertia_[n].inverse_moment, bodies[n].w);
    }
    return sum;
  });
  for (int axis = 0; is_driven_ && axis < 3; ++axis) {
    energy += 0.5 * moment_.rate[axis] * moment_.rate[axis] / axis_inverse_mass_[axis];
  }
  return energy;
}

Fastest Run::fastest() const {
  Lane stretch{1.0, 1.0, 1.0, 0.0};
  for (int axis = 0; axis < 3 && from_.cell.periodic; ++axis) {
    stretch[axis] = moment_.size[axis] / from_.cell.size[axis];
  }
  const std::span<const VerletBody> bodies = forces_.bodies();
  std::vector<Fastest> of_block(list_.blocks());
  parallel_blocks(bodies.size(), [&](std::size_t begin, std::size_t end) {
    Fastest& own = of_block[begin / block_size];
    for (std::size_t n = begin; n < end; ++n) {
      const Lane moved = bodies[n].x - stretch * start_[n];
      const double distance = dot(moved, moved)[0], speed = dot(bodies[n].v, bodies[n].v)[0],
                   turning = dot(bodies[n].w, bodies[n].w)[0];
      own.moved = std::max(own.moved, distance);
      own.speed = std::max(own.speed, std::isfinite(distance + speed) ? speed : infinity);
      own.turning = std::max(own.turning, std::isfinite(turning) ? turning : infinity);
    }
  });
  Fastest all;
  for (const Fastest& own : of_block) {
    all.speed = std::max(all.speed, std::sqrt(own.speed));
    all.moved = std::max(all.moved, std::sqrt(own.moved));
    all.turning = std::max(all.turning, std::sqrt(own.turning));
  }
  return all;
}

// What nothing resists must not fly through the list in a step.
void Run::limit_travel(double speed) {
  double push = 0.0;
  for (const VerletInertia& own : inertia_) push = std::max(push, dot(own.push, own.push)[0]);
  const double way = 0.1 * skin_;
  travel_limit_ = std::min(way / speed, std::sqrt(way / std::sqrt(push)));
}

// Paths of the necks by the rates of now for the time since the last look.
void Run::follow_paths() {
  forces_.set_shifts(moment_.size);
  const double duration = elapsed_ - followed_until_;
  parallel_blocks(forces_.bodies().size(), [&](std::size_t begin, std::size_t) {
    for (const VerletPair& pair : list_.pairs(begin / block_size)) {
      if (pair.kind == PairKind::neck) list_.add_to_paths(pair, forces_.path_rates(pair, moment_), duration);
    }
  });
  followed_until_ = elapsed_;
}

// Breaks necks and plans the next look. False when the list is used up.
bool Run::look() {
  follow_paths();
  parallel_blocks(forces_.bodies().size(), [&](std::size_t begin, std::size_t) {
    list_.break_thin(begin / block_size, forces_.bodies(), forces_.shifts());
  });
  const Fastest now = fastest();
  double closing = 2.0 * now.moved, closing_rate = 2.0 * now.speed;
  for (int axis = 0; axis < 3 && from_.cell.periodic; ++axis) {
    const double strain = std::abs(moment_.size[axis] / from_.cell.size[axis] - 1.0);
    closing = std::max(closing, 2.0 * now.moved + strain * 1.5 * largest_diameter_);
    closing_rate =
        std::max(closing_rate, 2.0 * now.speed + std::abs(moment_.rate[axis]) * 1.5 * largest_diameter_);
  }
  limit_travel(now.speed);
  // A third of what is left, because velocities may grow.
  const double steps = (skin_ - closing) / (3.0 * closing_rate * moment_.dt);
  if (steps < 1.0) return false;
  look_interval_ = std::min(
      {2 * look_interval_, most_steps_between_looks, static_cast<std::int64_t>(std::min(steps, 1e6))});
  look_due_ = steps_ + look_interval_;
  return true;
}

StepReport Run::until(const Stretch& stretch, const solve::Abandon& abandon) {
  StepReport report;
  Stopwatch watch;
  const auto count = std::max<std::int64_t>(1, static_cast<std::int64_t>(from_.particles.size()));
  const std::int64_t asked_every = std::max<std::int64_t>(1, particle_steps_between_asking / count);
  const double energy_before = kinetic_energy();
  const std::int64_t most =
      std::min(stretch.steps, std::clamp(most_particle_steps / count, least_steps, most_steps));
  while (steps_ < most) {
    if (steps_ % asked_every == 0 && solve::is_abandoned(abandon)) {
      report.verdict = Verdict::abandoned;
      return report;
    }
    const double left = duration_left(stretch.duration), dt = next_duration(left);
    step(dt);
    elapsed_ = dt == left ? stretch.duration : elapsed_ + dt;
    if (elapsed_ == stretch.duration) break;
    if (steps_ >= look_due_ && !look()) break;
  }
  const Fastest now = fastest();
  const bool runs_away =
      !(now.speed * moment_.dt <= runaway * mean_radius_) || !(now.turning * moment_.dt <= runaway);
  report.verdict = runs_away ? Verdict::unstable : Verdict::accepted;
  report.duration = elapsed_;
  report.steps = steps_;
  report.work = work_;
  report.work.inertia = kinetic_energy() - energy_before;
  report.work.imbalance = std::abs(report.work.in() - report.work.out());
  report.times.sweep = watch.lap();
  return report;
}

void Run::write_necks(State& to) const {
  const std::vector<std::size_t> rows = list_.necks();
  Contacts& contacts = to.contacts;
  parallel_for(contacts.size(), [&](std::size_t k) {
    const PairForces forces = forces_.forces_of(list_.pair(rows[k]), moment_);
    contacts.normal_force[k] = forces.normal;
    contacts.equilibrium_force[k] = forces.whole_pull - forces.pull;
    contacts.approach_velocity[k] = forces.approach_velocity;
    contacts.sliding_velocity[k] = to_vec3(forces.sliding_velocity);
  });
}

contact::ContactChanges Run::write_to(State& to) {
  follow_paths();
  to = from_;
  Particles& p = to.particles;
  const Vec3 rate = to_vec3(moment_.rate);
  for (std::size_t n = 0; n < p.size(); ++n) {
    const VerletBody& body = forces_.bodies()[n];
    p.position[n] = to_vec3(body.x);
    p.velocity[n] = to_vec3(body.v);
    if (from_.cell.periodic) p.velocity[n] += rate.cwiseProduct(p.position[n]);
    p.spin[n] = to_vec3(body.w);
    p.orientation[n] = turned(p.orientation[n], to_vec3(forces_.turns()[n]));
  }
  if (from_.cell.periodic) {
    to.cell.size = to_vec3(moment_.size);
    to.cell_rate = rate;
    for (int axis = 0; axis < 3; ++axis) {
      to.cell_strain[axis] += std::log(to.cell.size[axis] / from_.cell.size[axis]);
    }
  }
  to.time += elapsed_;
  to.last_step = moment_.dt;
  to.theta += furnace_.theta(from_.time, to.time);
  to.temperature = furnace_.temperature(to.time);
  const contact::ContactChanges changes = list_.write_back(to);
  write_necks(to);
  return changes;
}

}  // namespace

StepReport VerletStep::attempt(const State& from, const Stretch& stretch, State& to) {
  Stopwatch watch;
  Run run(settings_, furnace_, from);
  const double search = watch.lap();
  StepReport report = run.until(stretch, abandon_);
  watch.lap();
  if (report.verdict != Verdict::accepted) return report;
  State next;
  report.changes = run.write_to(next);
  to = std::move(next);
  report.times.search = search + watch.lap();
  return report;
}

double VerletStep::first_duration(const State&) const { return infinity; }

}  // namespace frit::integrate
