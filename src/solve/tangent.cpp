#include "solve/tangent.hpp"

#include <algorithm>

#include "core/parallel.hpp"

namespace frit::solve {
namespace {

template <class Real>
TangentEdge<Real> tangent_edge(const Edge& edge, double normal) {
  const auto real = [](double value) { return static_cast<Real>(value); };
  return {{real(edge.normal.x()), real(edge.normal.y()), real(edge.normal.z()), Real(0)},
          real(edge.arm_i),
          real(edge.arm_j),
          real(edge.sliding),
          real(normal - edge.sliding),
          real(edge.rolling),
          real(edge.twisting - edge.rolling),
          edge.i,
          edge.j};
}

// What an edge does to its two bodies.
template <class Real>
struct Pull {
  Lanes<Real> force, lever_moment, moment;  // lever_moment = normal x force, moment from bending
};

template <bool bends, class Real>
inline Pull<Real> pull_of(const TangentEdge<Real>& edge, const Motion<Real>& of_i, const Motion<Real>& of_j,
                          Lanes<Real> stretch) {
  const Lanes<Real> normal = load(edge.normal);
  const Lanes<Real> turning = edge.arm_i * of_i.w + edge.arm_j * of_j.w;
  const Lanes<Real> relative = of_i.u - of_j.u - stretch + cross(turning, normal);
  Pull<Real> pull;
  pull.force = edge.sliding * relative + edge.normal_excess * dot(relative, normal) * normal;
  pull.lever_moment = edge.sliding * cross(normal, relative);
  pull.moment = Lanes<Real>{};
  if constexpr (bends) {
    const Lanes<Real> turn = of_i.w - of_j.w;
    pull.moment = edge.rolling * turn + edge.twisting_excess * dot(normal, turn) * normal;
  }
  return pull;
}

void add_end(const Vec3& normal, double signed_arm, double sliding, double excess, DiagonalBlock& block) {
  const Mat3 along = normal * normal.transpose();
  block.translation += sliding * Mat3::Identity() + excess * along;
  block.coupling += signed_arm * sliding * normal;
  block.rotation += signed_arm * signed_arm * sliding * (Mat3::Identity() - along);
}

template <class Real>
void add_edge(const TangentEdge<Real>& edge, bool is_second, DiagonalBlock& block) {
  const Vec3 normal = normal_of(edge);
  const double sliding = edge.sliding;
  if (edge.i == edge.j) {  // its own copy: translations cancel, both arms turn together
    if (is_second) return;
    const double arm = double(edge.arm_i) + double(edge.arm_j);
    block.rotation += arm * arm * sliding * (Mat3::Identity() - normal * normal.transpose());
    return;
  }
  add_end(normal, is_second ? -double(edge.arm_j) : double(edge.arm_i), sliding, edge.normal_excess, block);
  block.rotation +=
      double(edge.rolling) * Mat3::Identity() + double(edge.twisting_excess) * normal * normal.transpose();
}

}  // namespace

Eigen::Matrix<double, 6, 6> DiagonalBlock::full() const {
  const Mat3 cross = cross_matrix(coupling);
  Eigen::Matrix<double, 6, 6> block;
  block << translation, -cross, cross, rotation;
  return block;
}

template <class Real>
TangentOperator<Real>::TangentOperator(const Problem& problem, const EdgeBlocks& blocks,
                                       std::span<const double> normal_stiffness)
    : problem_(problem),
      blocks_(blocks),
      resistance_(problem.mass.begin(), problem.mass.end()),
      spin_resistance_(problem.moment.begin(), problem.moment.end()) {
  edges_.resize(blocks_.entries());
  if (problem.has_axes) branch_.resize(blocks_.entries());
  count_.assign(kinds_of_ends * blocks_.count(), 0);
  axes_force_.resize(blocks_.count());
  std::vector<std::uint8_t> bends(blocks_.count(), 0);
  parallel_blocks(problem.bodies(), [&](std::size_t begin, std::size_t) {
    const std::size_t block = begin / block_size;
    fill(block, normal_stiffness);
    for (const Ends ends : all_ends) {
      for (const TangentEdge<Real>& edge : edges_of(block, ends)) {
        if (edge.rolling != Real(0) || edge.twisting_excess != Real(0)) bends[block] = 1;
      }
    }
  });
  const auto is_set = [](std::uint8_t value) { return value != 0; };
  bends_ = std::any_of(bends.begin(), bends.end(), is_set);
  holds_ = std::any_of(problem.held.begin(), problem.held.end(), is_set);
}

template <class Real>
void TangentOperator<Real>::fill(std::size_t block, std::span<const double> normal_stiffness) {
  for (const Ends ends : all_ends) {
    std::size_t next = blocks_.begin(block, ends);
    for (const std::uint32_t k : blocks_.edges(block, ends)) {
      const Edge& edge = problem_.edges[k];
      const double normal = normal_stiffness[k];
      if (normal == 0.0 && edge.sliding == 0.0 && edge.rolling == 0.0 && edge.twisting == 0.0) continue;
      edges_[next] = tangent_edge<Real>(edge, normal);
      if (problem_.has_axes) branch_[next] = lanes<Real>(problem_.branch[k]);
      ++next;
    }
    count_[list_of(block, ends)] = static_cast<std::uint32_t>(next - blocks_.begin(block, ends));
  }
}

template <class Real>
std::size_t TangentOperator<Real>::edges() const {
  std::size_t total = 0;
  for (std::size_t block = 0; block < blocks_.count(); ++block) {
    total += edges_of(block, Ends::both).size() + edges_of(block, Ends::first).size();
  }
  return total;
}

template <class Real>
std::span<const TangentEdge<Real>> TangentOperator<Real>::edges_of(std::size_t block, Ends ends) const {
  return {edges_.data() + blocks_.begin(block, ends), count_[list_of(block, ends)]};
}

template <class Real>
template <bool bends>
double TangentOperator<Real>::apply_block(std::size_t block, const Motion<Real>* in, Motion<Real>* out) {
  const std::size_t begin = block * block_size, end = std::min(problem_.bodies(), begin + block_size);
  for (std::size_t n = begin; n < end; ++n) {
    out[n] = {resistance_[n] * in[n].u, spin_resistance_[n] * in[n].w};
  }
  const Lanes<Real> axes = in[problem_.bodies()].u;
  Lanes<Real> axes_force{};
  for (const Ends ends : all_ends) {
    const std::size_t start = blocks_.begin(block, ends);
    const std::span<const TangentEdge<Real>> list = edges_of(block, ends);
    for (std::size_t n = 0; n < list.size(); ++n) {
      const TangentEdge<Real>& edge = list[n];
      const Lanes<Real> branch = branch_.empty() ? Lanes<Real>{} : branch_[start + n];
      const Pull<Real> pull = pull_of<bends>(edge, in[edge.i], in[edge.j], axes * branch);
      if (ends != Ends::second) {
        out[edge.i].u += pull.force;
        out[edge.i].w += edge.arm_i * pull.lever_moment + pull.moment;
        axes_force += pull.force * branch;
      }
      if (ends != Ends::first) {
        out[edge.j].u -= pull.force;
        out[edge.j].w += edge.arm_j * pull.lever_moment - pull.moment;
      }
    }
  }
  axes_force_[block] = to_vec3(axes_force);
  if (holds_) hold(begin, end, out);
  Lanes<double> total{};
  for (std::size_t n = begin; n < end; ++n) total += products(in[n], out[n]);
  return sum(total);
}

template <class Real>
void TangentOperator<Real>::hold(std::size_t begin, std::size_t end, Motion<Real>* out) const {
  for (std::size_t n = begin; n < end; ++n) {
    if ((problem_.held[n] & holds_translation) != 0) out[n].u = Lanes<Real>{};
    if ((problem_.held[n] & holds_rotation) != 0) out[n].w = Lanes<Real>{};
  }
}

template <class Real>
double TangentOperator<Real>::apply(std::span<const Motion<Real>> in, std::span<Motion<Real>> out) {
  const std::size_t bodies = problem_.bodies();
  const double total = ordered_sum(bodies, 0.0, [&](std::size_t begin, std::size_t) {
    const std::size_t block = begin / block_size;
    return bends_ ? apply_block<true>(block, in.data(), out.data())
                  : apply_block<false>(block, in.data(), out.data());
  });
  Vec3 axes = Vec3::Zero();
  for (const Vec3& force : axes_force_) axes -= force;
  for (int axis = 0; axis < 3; ++axis) {
    if (problem_.axis_held[axis]) axes[axis] = 0.0;
  }
  out[bodies] = {lanes<Real>(axes), Lanes<Real>{}};
  return total + sum(products(in[bodies], out[bodies]));
}

template <class Real>
void TangentOperator<Real>::apply(std::span<const double> in, std::span<double> out) {
  const std::size_t count = problem_.bodies() + 1;
  Motions<Real> from(count), to(count);
  for (std::size_t n = 0; n < count; ++n) from[n] = motion_at<Real>(in, n, 1.0);
  apply(std::span<const Motion<Real>>(from), std::span<Motion<Real>>(to));
  for (std::size_t n = 0; n < count; ++n) put_motion(to[n], n, 1.0, out);
}

template <class Real>
void TangentOperator<Real>::damp(double share) {
  parallel_blocks(problem_.bodies(), [&](std::size_t begin, std::size_t end) {
    const std::vector<DiagonalBlock> diagonal = diagonal_blocks(begin, end);
    for (std::size_t n = begin; n < end; ++n) {
      resistance_[n] += static_cast<Real>(share / 3.0 * diagonal[n - begin].translation.trace());
      spin_resistance_[n] += static_cast<Real>(share / 3.0 * diagonal[n - begin].rotation.trace());
    }
  });
}

template <class Real>
std::vector<DiagonalBlock> TangentOperator<Real>::diagonal_blocks(std::size_t begin, std::size_t end) const {
  std::vector<DiagonalBlock> diagonal(end - begin);
  for (std::size_t n = begin; n < end; ++n) {
    diagonal[n - begin].translation = double(resistance_[n]) * Mat3::Identity();
    diagonal[n - begin].rotation = double(spin_resistance_[n]) * Mat3::Identity();
  }
  for (const Ends ends : all_ends) {
    for (const TangentEdge<Real>& edge : edges_of(begin / block_size, ends)) {
      if (ends != Ends::second) add_edge(edge, false, diagonal[static_cast<std::size_t>(edge.i) - begin]);
      if (ends != Ends::first) add_edge(edge, true, diagonal[static_cast<std::size_t>(edge.j) - begin]);
    }
  }
  return diagonal;
}

template <class Real>
Mat3 TangentOperator<Real>::axes_block() const {
  Mat3 block = Mat3::Zero();
  if (branch_.empty()) return block;
  block = ordered_sum(problem_.bodies(), block, [&](std::size_t begin, std::size_t) {
    Mat3 part = Mat3::Zero();
    for (const Ends ends : {Ends::both, Ends::first}) {
      const std::size_t start = blocks_.begin(begin / block_size, ends);
      const std::span<const TangentEdge<Real>> list = edges_of(begin / block_size, ends);
      for (std::size_t n = 0; n < list.size(); ++n) {
        const Vec3 normal = normal_of(list[n]);
        const Vec3 branch = to_vec3(branch_[start + n]), along = branch.cwiseProduct(normal);
        part += double(list[n].normal_excess) * along * along.transpose();
        part.diagonal() += double(list[n].sliding) * branch.cwiseAbs2();
      }
    }
    return part;
  });
  for (int axis = 0; axis < 3; ++axis) {
    if (!problem_.axis_held[axis]) continue;
    block.row(axis).setZero();
    block.col(axis).setZero();
  }
  return block;
}

template class TangentOperator<float>;
template class TangentOperator<double>;

}  // namespace frit::solve
