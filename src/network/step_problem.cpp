#include "network/step_problem.hpp"

#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "contact/local_response.hpp"
#include "core/parallel.hpp"

namespace frit::network {
namespace {

// Of a sphere of mean radius in the dimensionless problem, where forces that matter are of the order of one:
// far below every tolerance.
constexpr double vanishing_mass = 1e-12;

using ConstVec = Eigen::Map<const Vec3>;
using contact::Pairing;

// Separation of a pair at both ends of the step [m].
struct Separations {
  Vec3 start, end;
};

class Builder {
 public:
  Builder(const StepInput& input, const solve::Solution* estimate) : in_(input), estimate_(estimate) {}

  solve::Problem build() {
    const std::size_t contacts = in_.state.contacts.size();
    problem_.edges.resize(contacts + in_.prospects.size());
    problem_.has_axes = in_.state.cell.periodic || in_.conditions.freedom == Freedom::affine;
    if (problem_.has_axes) problem_.branch.resize(problem_.edges.size());
    parallel_for(contacts, [&](std::size_t k) { add_neck(k); });
    parallel_for(in_.prospects.size(), [&](std::size_t n) { add_prospect(contacts + n, in_.prospects[n]); });
    add_bodies();
    carry_rattlers();
    if (problem_.has_axes) add_axes();
    problem_.force_unit = driving_force();
    return std::move(problem_);
  }

 private:
  Pairing pairing_of(const neighbor::Pair& pair) const {
    const std::vector<double>& radius = in_.state.particles.radius;
    return {radius[static_cast<std::size_t>(pair.i)], radius[static_cast<std::size_t>(pair.j)]};
  }

  Separations separations(const neighbor::Pair& pair) const {
    const Particles& p = in_.state.particles;
    const auto i = static_cast<std::size_t>(pair.i), j = static_cast<std::size_t>(pair.j);
    Separations d;
    d.start = in_.state.cell.separation(p.position[i], p.position[j], pair.image);
    d.end = d.start;
    if (estimate_ == nullptr) return d;
    const double* motion = estimate_->motion.data();
    d.end += in_.scale.length * (ConstVec(motion + 6 * j) - ConstVec(motion + 6 * i));
    if (problem_.has_axes) d.end += ConstVec(motion + 6 * p.size()).cwiseProduct(d.start);
    return d;
  }

  // Normal, arms and approach scale of mid-step; arms share the distance as the radii do (physics: with arms
  // equal to the radii an overlapped pair would resist a rigid rotation).
  void set_geometry(std::size_t k, const neighbor::Pair& pair, const Separations& d) {
    solve::Edge& edge = problem_.edges[k];
    const Pairing pairing = pairing_of(pair);
    const Vec3 middle = 0.5 * (d.start + d.end);
    const double distance = middle.norm();
    edge.i = pair.i;
    edge.j = pair.j;
    edge.normal = middle / distance;
    edge.approach_scale = 2.0 * distance / (d.start.norm() + d.end.norm());
    const double share = pairing.radius_i / (pairing.radius_i + pairing.radius_j);
    edge.arm_i = share * distance / in_.scale.length;
    edge.arm_j = (1.0 - share) * distance / in_.scale.length;
    if (problem_.has_axes) problem_.branch[k] = d.start / in_.scale.length;
  }

  void set_response(std::size_t k, const contact::LocalResponse& r) {
    const double length = in_.scale.length, force = in_.scale.force, area = length * length;
    solve::Edge& edge = problem_.edges[k];
    edge.response.viscosity = r.viscosity * area * area * area / force;
    edge.response.start = r.start / area;
    edge.response.growth = r.growth / length;
    edge.response.floor = r.floor / area;
    edge.response.cap = r.cap / area;
    edge.response.pull = r.pull / force;
    edge.response.threshold = r.threshold / length;
    edge.response.limit = r.limit / force;
    edge.response.opens_freely = r.opens_freely;
    edge.sliding = r.sliding * length / force;
    edge.rolling = r.rolling / (force * length);
    edge.twisting = r.twisting / (force * length);
  }

  void add_neck(std::size_t k) {
    const Contacts& contacts = in_.state.contacts;
    const neighbor::Pair pair{contacts.i[k], contacts.j[k], contacts.image[k]};
    const Separations d = separations(pair);
    const Pairing pairing = pairing_of(pair);
    const double start = contacts.neck_radius_squared[k];
    const double end = start + 2.0 * pairing.equivalent * (d.start.norm() - d.end.norm());
    set_geometry(k, pair, d);
    set_response(k, contact::respond(in_.law, pairing, {start, end}, in_.conditions.theta));
  }

  void add_prospect(std::size_t k, const contact::Prospect& prospect) {
    const Separations d = separations(prospect.pair);
    set_geometry(k, prospect.pair, d);
    if (in_.law.closing == contact::Closing::rigid) {
      set_response(k, contact::respond_rigid(prospect.gap));
      return;
    }
    const contact::ClosingStep step{prospect.gap, d.start.norm() - d.end.norm()};
    set_response(k, contact::respond_closing(in_.law, pairing_of(prospect.pair), step, in_.conditions.theta));
  }

  void add_bodies() {
    const Particles& p = in_.state.particles;
    const std::size_t count = p.size();
    problem_.mass.assign(count, 0.0);
    problem_.moment.assign(count, 0.0);
    problem_.load.assign(count, Vec3::Zero());
    problem_.torque.assign(count, Vec3::Zero());
    problem_.held.assign(count, 0);
    problem_.position.resize(count);
    const double length = in_.scale.length, force = in_.scale.force, dt = in_.conditions.duration;
    parallel_for(count, [&](std::size_t n) {
      problem_.held[n] = held(p, n);
      problem_.position[n] = p.position[n] / length;
      problem_.load[n] = p.force[n] / force;
      const double gyration = p.radius[n] / length;
      problem_.mass[n] = in_.conditions.inertia == Inertia::vanishing
                             ? vanishing_mass * gyration * gyration * gyration
                             : p.mass[n] / (dt * dt) * length / force;
      problem_.moment[n] = 0.4 * gyration * gyration * problem_.mass[n];
      if (in_.conditions.inertia != Inertia::dynamic) return;
      const Vec3 affine = in_.state.cell_rate.cwiseProduct(p.position[n]);
      const Vec3 own = in_.state.cell.periodic ? Vec3(p.velocity[n] - affine) : p.velocity[n];
      problem_.load[n] += problem_.mass[n] * own * dt / length;
      problem_.torque[n] += problem_.moment[n] * p.spin[n] * dt;
    });
  }

  std::uint8_t held(const Particles& p, std::size_t n) const {
    if (p.fixed[n] != 0 || in_.conditions.freedom == Freedom::affine) {
      return solve::holds_translation | solve::holds_rotation;
    }
    return in_.conditions.spins_blocked ? solve::holds_rotation : std::uint8_t{0};
  }

  // Particles without a neck have no force of their own: they start with the mean motion of the particles
  // around them (theory.md, section 4), and prospects push them from there.
  void carry_rattlers() {
    if (estimate_ == nullptr || in_.conditions.inertia == Inertia::dynamic) return;
    const Contacts& contacts = in_.state.contacts;
    std::vector<std::uint8_t> bonded(problem_.bodies(), 0);
    for (std::size_t k = 0; k < contacts.size(); ++k) {
      bonded[static_cast<std::size_t>(contacts.i[k])] = bonded[static_cast<std::size_t>(contacts.j[k])] = 1;
    }
    std::vector<Vec3> sum(problem_.bodies(), Vec3::Zero());
    std::vector<int> around(problem_.bodies(), 0);
    const auto look = [&](std::int32_t rattler, std::int32_t other) {
      const auto r = static_cast<std::size_t>(rattler), o = static_cast<std::size_t>(other);
      if (bonded[r] != 0 || bonded[o] == 0) return;
      sum[r] += ConstVec(estimate_->motion.data() + 6 * o);
      ++around[r];
    };
    for (const contact::Prospect& prospect : in_.prospects) {
      look(prospect.pair.i, prospect.pair.j);
      look(prospect.pair.j, prospect.pair.i);
    }
    problem_.carried.assign(problem_.bodies(), Vec3::Zero());
    for (std::size_t n = 0; n < problem_.bodies(); ++n) {
      if (around[n] > 0) problem_.carried[n] = sum[n] / around[n];
    }
  }

  void add_axes() {
    const bool periodic = in_.state.cell.periodic;
    const Vec3 size = in_.state.cell.size / in_.scale.length;
    Vec3 gradient = Vec3::Zero();
    if (estimate_ != nullptr) gradient = ConstVec(estimate_->motion.data() + 6 * problem_.bodies());
    const double pressure_unit = in_.scale.force / (in_.scale.length * in_.scale.length);
    for (int axis = 0; axis < 3; ++axis) {
      problem_.axis_held[axis] = in_.conditions.axis_prescribed[axis];
      if (!periodic) continue;
      double volume = size.prod();
      for (int other = 0; other < 3; ++other) volume *= other == axis ? 1.0 : 1.0 + 0.5 * gradient[other];
      problem_.axis_load[axis] = in_.conditions.stress[axis] / pressure_unit * volume;
    }
  }

  double driving_force() const {
    double squares = ordered_sum(problem_.edges.size(), 0.0, [&](std::size_t begin, std::size_t end) {
      double sum = 0.0;
      for (std::size_t k = begin; k < end; ++k) {
        const double pull = problem_.edges[k].response.pull;
        sum += 2.0 * pull * pull;
      }
      return sum;
    });
    for (const Vec3& load : problem_.load) squares += load.squaredNorm();
    return squares > 0.0 ? std::sqrt(squares) : 1.0;
  }

  const StepInput& in_;
  const solve::Solution* estimate_;
  solve::Problem problem_;
};

}  // namespace

Scale scale_of(const Particles& particles, const contact::SinteringLaw& law) {
  double sum = 0.0;
  for (const double radius : particles.radius) sum += radius;
  const double mean = sum / static_cast<double>(particles.size());
  return {mean, law.surface_energy * mean};
}

solve::Problem make_problem(const StepInput& input, const solve::Solution* estimate) {
  return Builder(input, estimate).build();
}

solve::Solution make_start(const StepInput& input, const solve::Problem& problem) {
  solve::Solution start = solve::Solution::at_rest(problem);
  const Contacts& contacts = input.state.contacts;
  for (std::size_t k = 0; k < contacts.size(); ++k) {
    start.multiplier[k] = contacts.equilibrium_force[k] / input.scale.force;
  }
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (input.conditions.axis_prescribed[axis]) {
      start.motion[6 * problem.bodies() + axis] = input.conditions.axis_gradient[static_cast<int>(axis)];
    }
  }
  return start;
}

Vec3 displacement(const StepInput& input, const solve::Solution& solution, std::size_t particle) {
  const Vec3& position = input.state.particles.position[particle];
  const double* motion = solution.motion.data();
  const std::size_t bodies = input.state.particles.size();
  Vec3 moved = input.scale.length * ConstVec(motion + 6 * particle);
  if (input.state.cell.periodic || input.conditions.freedom == Freedom::affine) {
    moved += ConstVec(motion + 6 * bodies).cwiseProduct(position);
  }
  return moved;
}

}  // namespace frit::network
