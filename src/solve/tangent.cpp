#include "solve/tangent.hpp"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "core/parallel.hpp"
#include "solve/response.hpp"

namespace frit::solve {
namespace {

using ConstVec = Eigen::Map<const Vec3>;
using Block = Eigen::Matrix<double, 6, 6>;

// Stiffness of the viscous part: its tangent 3 viscosity growth q^2, except where Newton's method would be
// thrown far off by it. A neck far smaller than its own pull would make it in the step (a young one), or one
// torn in the trial motion, gets the chord to that size: the tangent overshoots on a cubic and vanishes on a
// torn neck.
double viscous_stiffness(const NormalResponse& r, double approach, Stiffness kind) {
  if (r.viscosity == 0.0 || is_open(r, approach)) return 0.0;
  const double start = std::clamp(r.start, 0.0, r.cap);
  const double q = r.start + r.growth * approach;
  const double free_q = std::min(r.cap, std::cbrt(start * start * start + r.pull / r.viscosity));
  const bool is_torn = r.pull > 0.0 && q < 0.25 * free_q;
  const bool is_far = kind == Stiffness::guarded && free_q > 2.0 * q;
  if (is_torn || is_far) {
    return r.growth * (viscous_potential(r, free_q) - viscous_potential(r, q)) / (free_q - q);
  }
  return viscous_tangent(r, approach);
}

// Stiffness of the normal response, multiplier included, at the approach the gradient was evaluated at.
double normal_stiffness(const Edge& edge, double approach, double multiplier, double penalty,
                        Stiffness kind) {
  double stiffness = viscous_stiffness(edge.response, approach, kind);
  const bool on_the_set = multiplier > 0.0 && multiplier < edge.response.limit;
  if (on_the_set) stiffness += penalty;
  return stiffness * edge.approach_scale * edge.approach_scale;
}

void add_edge_block(const TangentEdge& edge, bool is_second, Block& block) {
  const Vec3 normal = ConstVec(edge.normal);
  const double sign = is_second ? -1.0 : 1.0;
  const double arm = is_second ? edge.arm_j : edge.arm_i;
  Mat3 cross;
  cross << 0, -normal.z(), normal.y(), normal.z(), 0, -normal.x(), -normal.y(), normal.x(), 0;
  const Mat3 along = normal * normal.transpose();
  const double sliding = edge.sliding;
  block.topLeftCorner<3, 3>() += sliding * Mat3::Identity() + edge.normal_excess * along;
  block.topRightCorner<3, 3>() -= sign * arm * sliding * cross;
  block.bottomLeftCorner<3, 3>() += sign * arm * sliding * cross;
  block.bottomRightCorner<3, 3>() += arm * arm * sliding * (Mat3::Identity() - along);
}

// Inverse of a block without the directions that resist only round-off. The metric of the inertia (rotation
// scaled by the radius of gyration) decides what is shortest, as in the limit of vanishing inertia.
Block pseudo_inverse(const Block& block, double mass, double moment) {
  const double gyration = mass > 0.0 && moment > 0.0 ? std::sqrt(moment / mass) : 1.0;
  Eigen::Matrix<double, 6, 1> scale;
  scale << Vec3::Ones(), Vec3::Constant(1.0 / gyration);
  const Block scaled = scale.asDiagonal() * block * scale.asDiagonal();
  const Eigen::SelfAdjointEigenSolver<Block> eigen(scaled);
  const double threshold = 1e-13 * eigen.eigenvalues()[5];
  Eigen::Matrix<double, 6, 1> inverted;
  for (int n = 0; n < 6; ++n) {
    inverted[n] = eigen.eigenvalues()[n] > threshold ? 1.0 / eigen.eigenvalues()[n] : 0.0;
  }
  const Block inverse = eigen.eigenvectors() * inverted.asDiagonal() * eigen.eigenvectors().transpose();
  return scale.asDiagonal() * inverse * scale.asDiagonal();
}

Block invert(const Block& block, double mass, double moment) {
  const Eigen::Matrix<double, 6, 1> diagonal = block.diagonal();
  if (diagonal.maxCoeff() <= 0.0) return Block::Zero();
  if (diagonal.minCoeff() <= 0.0) return pseudo_inverse(block, mass, moment);
  const Eigen::Matrix<double, 6, 1> scale = diagonal.cwiseSqrt().cwiseInverse();
  const Eigen::LLT<Block> factor(scale.asDiagonal() * block * scale.asDiagonal());
  const bool clear = factor.info() == Eigen::Success && factor.matrixLLT().diagonal().minCoeff() > 1e-5;
  if (!clear) return pseudo_inverse(block, mass, moment);
  const Block inverse = factor.solve(Block::Identity());
  return scale.asDiagonal() * (0.5 * (inverse + inverse.transpose())) * scale.asDiagonal();
}

// Held unknowns uncoupled; the unit diagonal keeps the block invertible and meets only zeros.
void hold(Block& block, std::uint8_t held) {
  for (int n = 0; n < 6; ++n) {
    if ((held & (n < 3 ? holds_translation : holds_rotation)) == 0) continue;
    block.row(n).setZero();
    block.col(n).setZero();
    block(n, n) = 1.0;
  }
}

std::vector<std::array<std::int32_t, 2>> ends_of(const std::vector<TangentEdge>& edges) {
  std::vector<std::array<std::int32_t, 2>> ends(edges.size());
  for (std::size_t k = 0; k < ends.size(); ++k) ends[k] = {edges[k].i, edges[k].j};
  return ends;
}

std::vector<TangentEdge> stiff_edges(const Problem& problem, const Gradient& at,
                                     std::span<const double> penalty, Stiffness kind,
                                     std::vector<std::size_t>& kept) {
  std::vector<TangentEdge> edges;
  edges.reserve(problem.edges.size());
  for (std::size_t k = 0; k < problem.edges.size(); ++k) {
    const Edge& edge = problem.edges[k];
    const double normal = normal_stiffness(edge, at.approach()[k], at.multiplier()[k], penalty[k], kind);
    if (normal == 0.0 && edge.sliding == 0.0 && edge.rolling == 0.0) continue;
    edges.push_back({{edge.normal.x(), edge.normal.y(), edge.normal.z()},
                     edge.arm_i,
                     edge.arm_j,
                     normal - edge.sliding,
                     edge.sliding,
                     edge.i,
                     edge.j});
    kept.push_back(k);
  }
  return edges;
}

}  // namespace

TangentOperator::TangentOperator(const Problem& problem, const Gradient& at, std::span<const double> penalty,
                                 Stiffness kind)
    : problem_(problem), incidence_(0, {}) {
  std::vector<std::size_t> kept;
  kept.reserve(problem.edges.size());
  edges_ = stiff_edges(problem, at, penalty, kind, kept);
  incidence_ = Incidence(problem.bodies(), ends_of(edges_));
  force_.resize(edges_.size());
  bool bends = false;
  for (const std::size_t k : kept) {
    if (problem.has_axes) branch_.push_back(problem.branch[k]);
    bends = bends || problem.edges[k].rolling != 0.0 || problem.edges[k].twisting != 0.0;
  }
  if (!bends) return;
  moment_.resize(edges_.size());
  for (const std::size_t k : kept) {
    rolling_.push_back(problem.edges[k].rolling);
    twisting_.push_back(problem.edges[k].twisting);
  }
}

void TangentOperator::act_on_edge(std::size_t k, std::span<const double> in) {
  const TangentEdge& edge = edges_[k];
  const double* of_i = in.data() + 6 * static_cast<std::size_t>(edge.i);
  const double* of_j = in.data() + 6 * static_cast<std::size_t>(edge.j);
  const Vec3 normal = ConstVec(edge.normal);
  Vec3 relative = ConstVec(of_i) - ConstVec(of_j);
  if (!branch_.empty()) relative -= ConstVec(in.data() + 6 * problem_.bodies()).cwiseProduct(branch_[k]);
  const Vec3 turning = edge.arm_i * ConstVec(of_i + 3) + edge.arm_j * ConstVec(of_j + 3);
  relative += turning.cross(normal);
  const Vec3 force = edge.sliding * relative + edge.normal_excess * relative.dot(normal) * normal;
  force_[k] = {force, normal.cross(force)};
  if (!moment_.empty()) {
    const Vec3 turn = ConstVec(of_i + 3) - ConstVec(of_j + 3);
    moment_[k] = rolling_[k] * turn + (twisting_[k] - rolling_[k]) * normal.dot(turn) * normal;
  }
}

void TangentOperator::gather_body(std::size_t body, std::span<const double> in, std::span<double> out) const {
  const double* own = in.data() + 6 * body;
  Vec3 force = problem_.mass[body] * ConstVec(own);
  Vec3 moment = problem_.moment[body] * ConstVec(own + 3);
  for (const Incident incident : incidence_.at(body)) {
    const std::size_t k = incident.edge();
    if (incident.is_second()) {
      force -= force_[k].force;
      moment += edges_[k].arm_j * force_[k].lever_moment;
      if (!moment_.empty()) moment -= moment_[k];
    } else {
      force += force_[k].force;
      moment += edges_[k].arm_i * force_[k].lever_moment;
      if (!moment_.empty()) moment += moment_[k];
    }
  }
  const std::uint8_t held = problem_.held[body];
  if ((held & holds_translation) != 0) force.setZero();
  if ((held & holds_rotation) != 0) moment.setZero();
  Eigen::Map<Vec3>(out.data() + 6 * body) = force;
  Eigen::Map<Vec3>(out.data() + 6 * body + 3) = moment;
}

void TangentOperator::gather_axes(std::span<double> out) const {
  Vec3 total = Vec3::Zero();
  if (!branch_.empty()) {
    total = -ordered_sum(edges_.size(), Vec3(Vec3::Zero()), [&](std::size_t begin, std::size_t end) {
      Vec3 sum = Vec3::Zero();
      for (std::size_t k = begin; k < end; ++k) sum += force_[k].force.cwiseProduct(branch_[k]);
      return sum;
    });
  }
  for (int axis = 0; axis < 3; ++axis) {
    out[6 * problem_.bodies() + axis] = problem_.axis_held[axis] ? 0.0 : total[axis];
  }
}

void TangentOperator::apply(std::span<const double> in, std::span<double> out) {
  parallel_for(edges_.size(), [&](std::size_t k) { act_on_edge(k, in); });
  parallel_for(problem_.bodies(), [&](std::size_t body) { gather_body(body, in, out); });
  gather_axes(out);
}

Block TangentOperator::body_block(std::size_t body) const {
  Block block = Block::Zero();
  block.diagonal() << Vec3::Constant(problem_.mass[body]), Vec3::Constant(problem_.moment[body]);
  for (const Incident incident : incidence_.at(body)) {
    const std::size_t k = incident.edge();
    const TangentEdge& edge = edges_[k];
    if (edge.i == edge.j) {  // its own copy: translations cancel, both arms turn together
      TangentEdge turning = edge;
      turning.arm_i = turning.arm_j = std::sqrt(0.5) * (edge.arm_i + edge.arm_j);
      Block both = Block::Zero();
      add_edge_block(turning, false, both);
      block.bottomRightCorner<3, 3>() += both.bottomRightCorner<3, 3>();
      continue;
    }
    add_edge_block(edge, incident.is_second(), block);
    if (!moment_.empty()) {
      const Vec3 normal = ConstVec(edge.normal);
      block.bottomRightCorner<3, 3>() +=
          rolling_[k] * Mat3::Identity() + (twisting_[k] - rolling_[k]) * normal * normal.transpose();
    }
  }
  hold(block, problem_.held[body]);
  return block;
}

Mat3 TangentOperator::axes_block() const {
  Mat3 block = Mat3::Zero();
  for (std::size_t k = 0; k < branch_.size(); ++k) {
    const Vec3 normal = ConstVec(edges_[k].normal);
    const Vec3 along = branch_[k].cwiseProduct(normal);
    block += edges_[k].normal_excess * along * along.transpose();
    block.diagonal() += edges_[k].sliding * branch_[k].cwiseAbs2();
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (!problem_.axis_held[axis]) continue;
    block.row(axis).setZero();
    block.col(axis).setZero();
  }
  return block;
}

BlockJacobi::BlockJacobi(const TangentOperator& matrix) : inverse_(matrix.problem().bodies()) {
  const Problem& problem = matrix.problem();
  parallel_for(inverse_.size(), [&](std::size_t body) {
    inverse_[body] = invert(matrix.body_block(body), problem.mass[body], problem.moment[body]);
  });
  if (!problem.has_axes) return;
  Block padded = Block::Zero();
  padded.topLeftCorner<3, 3>() = matrix.axes_block();
  axes_inverse_ = pseudo_inverse(padded, 1.0, 1.0).topLeftCorner<3, 3>();
}

void BlockJacobi::apply_body(std::size_t body, const double* in, double* out) const {
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  Eigen::Map<Vector6>(out).noalias() = inverse_[body] * Eigen::Map<const Vector6>(in);
}

void BlockJacobi::apply_axes(const double* in, double* out) const {
  Eigen::Map<Vec3>{out} = axes_inverse_ * ConstVec(in);
}

}  // namespace frit::solve
