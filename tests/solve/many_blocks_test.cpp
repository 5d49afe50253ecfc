// Gradient and operator of problems of several blocks of bodies, against plain sums over the edges.
#include <gtest/gtest.h>

#include "core/parallel.hpp"
#include "solve/conjugate_gradients.hpp"
#include "solve/energy.hpp"
#include "solve/linearised.hpp"

namespace frit::solve {
namespace {

using namespace testing;

const std::vector<Kind> smooth_kinds{Kind::neck, Kind::beyond_cap, Kind::closing_gap, Kind::equilibrium_box,
                                     Kind::rigid_gap};

// Four blocks, edges within and between all of them; some bodies are held, some carried. No neck is so young
// that the operator guards it with a chord (tangent.cpp).
Problem large_problem(Dice& dice) {
  Problem p = arbitrary_problem({.bodies = 3300, .edges = 12000}, smooth_kinds, dice);
  for (Edge& edge : p.edges) {
    if (edge.response.start > 0.0) {
      edge.response.start = std::max(edge.response.start, 0.5 * edge.response.cap);
    }
  }
  for (std::size_t n = 0; n < p.bodies(); ++n) {
    p.carried.push_back(dice.vector(0.1));
    if (n % 11 == 3) p.held[n] = static_cast<std::uint8_t>(1 + dice.below(3));
  }
  p.axis_held = {false, true, false};
  return p;
}

Eigen::VectorXd vector_of(const std::vector<double>& values) {
  return Eigen::Map<const Eigen::VectorXd>(values.data(), static_cast<Eigen::Index>(values.size()));
}

void clear_held(const Problem& p, Eigen::VectorXd& sum) {
  for (std::size_t n = 0; n < p.bodies(); ++n) {
    const auto row = static_cast<Eigen::Index>(6 * n);
    if ((p.held[n] & holds_translation) != 0) sum.segment<3>(row).setZero();
    if ((p.held[n] & holds_rotation) != 0) sum.segment<3>(row + 3).setZero();
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (p.axis_held[axis]) sum[sum.size() - 3 + axis] = 0.0;
  }
}

struct Pull {
  Vec3 force, moment;  // on the first body
};

// By virtual work: what a force between the two points of contact does to all unknowns.
void add_pull(const Problem& p, std::size_t k, const Pull& pull, Eigen::VectorXd& sum) {
  const Edge& e = p.edges[k];
  const Vec3 lever = e.normal.cross(pull.force);
  sum.segment<3>(6 * e.i) += pull.force;
  sum.segment<3>(6 * e.i + 3) += e.arm_i * lever + pull.moment;
  sum.segment<3>(6 * e.j) -= pull.force;
  sum.segment<3>(6 * e.j + 3) += e.arm_j * lever - pull.moment;
  sum.tail<3>() -= p.branch[k].cwiseProduct(pull.force);
}

// An edge's pull for a relative motion and a normal force; everything but the normal force is linear.
Pull pull_of(const Problem& p, std::size_t k, const std::vector<double>& motion, double normal_force) {
  const Edge& e = p.edges[k];
  const Mat3 along = e.normal * e.normal.transpose(), across = Mat3::Identity() - along;
  const Vec3 turn = three(motion, 6 * static_cast<std::size_t>(e.i) + 3) -
                    three(motion, 6 * static_cast<std::size_t>(e.j) + 3);
  return {normal_force * e.normal + e.sliding * across * contact_motion(p, k, motion),
          (e.twisting * along + e.rolling * across) * turn};
}

double approach_of(const Problem& p, std::size_t k, const std::vector<double>& motion) {
  return p.edges[k].approach_scale * contact_motion(p, k, motion).dot(p.edges[k].normal);
}

double multiplier_of(const Linearised<double>& l, std::size_t k) {
  const NormalResponse& r = l.problem.edges[k].response;
  if (r.limit == 0.0) return 0.0;
  const double trial =
      l.at.multiplier[k] + l.penalty[k] * (approach_of(l.problem, k, l.at.motion) - r.threshold);
  return std::min(std::max(trial, 0.0), r.limit);
}

Eigen::VectorXd summed_gradient(const Linearised<double>& l) {
  const Problem& p = l.problem;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(p.unknowns()));
  for (std::size_t n = 0; n < p.bodies(); ++n) {
    const auto row = static_cast<Eigen::Index>(6 * n);
    sum.segment<3>(row) = p.mass[n] * (three(l.at.motion, 6 * n) - p.carried[n]) - p.load[n];
    sum.segment<3>(row + 3) = p.moment[n] * three(l.at.motion, 6 * n + 3) - p.torque[n];
  }
  sum.tail<3>() = -p.axis_load;
  for (std::size_t k = 0; k < p.edges.size(); ++k) {
    const NormalResponse& r = p.edges[k].response;
    const double size = r.start + r.growth * approach_of(p, k, l.at.motion);
    const double force = potential(r, size) - potential(r, r.start) - r.pull + multiplier_of(l, k);
    add_pull(p, k, pull_of(p, k, l.at.motion, p.edges[k].approach_scale * force), sum);
  }
  clear_held(p, sum);
  return sum;
}

// The linearised problem's forces for a motion `v` from the point.
Eigen::VectorXd summed_product(const Linearised<double>& l, const std::vector<double>& v) {
  const Problem& p = l.problem;
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(p.unknowns()));
  for (std::size_t n = 0; n < p.bodies(); ++n) {
    const auto row = static_cast<Eigen::Index>(6 * n);
    sum.segment<3>(row) = p.mass[n] * three(v, 6 * n);
    sum.segment<3>(row + 3) = p.moment[n] * three(v, 6 * n + 3);
  }
  for (std::size_t k = 0; k < p.edges.size(); ++k) {
    const NormalResponse& r = p.edges[k].response;
    double slope = r.growth * potential_slope(r, r.start + r.growth * approach_of(p, k, l.at.motion));
    const double multiplier = multiplier_of(l, k);
    if (multiplier > 0.0 && multiplier < r.limit) slope += l.penalty[k];
    add_pull(p, k, pull_of(p, k, v, p.edges[k].approach_scale * slope * approach_of(p, k, v)), sum);
  }
  clear_held(p, sum);
  return sum;
}

// Zero where something is held, as the operator asks.
std::vector<double> random_direction(const Problem& p, Dice& dice) {
  Eigen::VectorXd values(static_cast<Eigen::Index>(p.unknowns()));
  for (double& value : values) value = dice.between(-1.0, 1.0);
  clear_held(p, values);
  return {values.begin(), values.end()};
}

template <class Real>
Eigen::VectorXd product(TangentOperator<Real>& matrix, const std::vector<double>& v) {
  std::vector<double> out(v.size());
  matrix.apply(v, out);
  return vector_of(out);
}

TEST(ManyBlocks, HaveTheGradientThatPlainSumsGive) {
  Dice dice(1);
  const Linearised<double> l(large_problem(dice), 0.01, dice);
  const Eigen::VectorXd expected = summed_gradient(l);
  EXPECT_LT((vector_of(l.gradient.values()) - expected).lpNorm<Eigen::Infinity>(), 1e-12 * expected.norm());
  for (std::size_t k = 0; k < l.problem.edges.size(); ++k) {
    ASSERT_NEAR(l.gradient.approach()[k], approach_of(l.problem, k, l.at.motion), 1e-14);
    ASSERT_NEAR(l.gradient.multiplier()[k], multiplier_of(l, k), 1e-13);
  }
}

TEST(ManyBlocks, HaveTheOperatorThatPlainSumsGive) {
  Dice dice(2);
  Linearised<double> l(large_problem(dice), 0.01, dice);
  for (int draw = 0; draw < 3; ++draw) {
    const std::vector<double> v = random_direction(l.problem, dice);
    const Eigen::VectorXd expected = summed_product(l, v);
    EXPECT_LT((product(l.matrix, v) - expected).lpNorm<Eigen::Infinity>(), 1e-13 * expected.norm());
  }
}

TEST(ManyBlocks, HaveTheSameOperatorInFloatToSixDigits) {
  Dice dice(3);
  const Problem p = large_problem(dice);
  const Solution at = random_solution(p, 0.01, dice);
  Linearised<double> fine(p, at);
  Linearised<float> rough(p, at);
  EXPECT_EQ(rough.matrix.edges(), fine.matrix.edges());
  for (int draw = 0; draw < 3; ++draw) {
    const std::vector<double> v = random_direction(p, dice);
    const Eigen::VectorXd exact = product(fine.matrix, v);
    EXPECT_LT((product(rough.matrix, v) - exact).norm(), 1e-6 * exact.norm());
  }
}

template <class Real>
double error_of_scalar_product(const Problem& p, const Solution& at, const std::vector<double>& v) {
  Linearised<Real> l(p, at);
  const Motions<Real> in = motions_of<Real>(vector_of(v));
  Motions<Real> out(in.size());
  const double told = l.matrix.apply(std::span<const Motion<Real>>(in), std::span<Motion<Real>>(out));
  const double found = testing::vector_of(in).dot(testing::vector_of(out));
  return std::abs(told / found - 1.0);
}

TEST(ManyBlocks, TellTheScalarProductOfMotionAndForce) {
  Dice dice(4);
  const Problem p = large_problem(dice);
  const Solution at = random_solution(p, 0.01, dice);
  const std::vector<double> v = random_direction(p, dice);
  EXPECT_LT(error_of_scalar_product<double>(p, at, v), 1e-13);
  EXPECT_LT(error_of_scalar_product<float>(p, at, v), 1e-6);
}

TEST(ManyBlocks, HaveTheDiagonalBlocksOfTheirOperator) {
  Dice dice(5);
  Problem p = large_problem(dice);
  std::fill(p.held.begin(), p.held.end(), std::uint8_t{0});
  Linearised<double> l(p, 0.01, dice);
  std::vector<double> unit(p.unknowns(), 0.0);
  for (const std::size_t body : {0U, 1023U, 1024U, 2047U, 2500U, 3299U}) {
    const Matrix6 block = body_block(l.matrix, body);
    const auto row = static_cast<Eigen::Index>(6 * body);
    for (std::size_t column = 0; column < 6; ++column) {
      unit[6 * body + column] = 1.0;
      const Vector6 expected = product(l.matrix, unit).segment<6>(row);
      EXPECT_LT((block.col(static_cast<Eigen::Index>(column)) - expected).norm(), 1e-13 * block.norm());
      unit[6 * body + column] = 0.0;
    }
  }
}

TEST(Damping, AddsAShareOfTheMeanStiffnessOfEveryBody) {
  Dice dice(6);
  Problem p = large_problem(dice);
  Linearised<double> plain(p), damped(p);
  damped.matrix.damp(0.25);
  const std::vector<double> v = random_direction(p, dice);
  const Eigen::VectorXd added = product(damped.matrix, v) - product(plain.matrix, v);
  Eigen::VectorXd expected = Eigen::VectorXd::Zero(added.size());
  for (std::size_t begin = 0; begin < p.bodies(); begin += block_size) {
    const std::size_t end = std::min(p.bodies(), begin + block_size);
    const std::vector<DiagonalBlock> blocks = plain.matrix.diagonal_blocks(begin, end);
    for (std::size_t n = begin; n < end; ++n) {
      const double shift = 0.25 / 3.0 * blocks[n - begin].translation.trace();
      const double spin = 0.25 / 3.0 * blocks[n - begin].rotation.trace();
      const auto row = static_cast<Eigen::Index>(6 * n);
      expected.segment<3>(row) = shift * three(v, 6 * n);
      expected.segment<3>(row + 3) = spin * three(v, 6 * n + 3);
      EXPECT_NEAR(damped.matrix.resistance(n), p.mass[n] + shift, 1e-12);
      EXPECT_NEAR(damped.matrix.spin_resistance(n), p.moment[n] + spin, 1e-12);
    }
  }
  clear_held(p, expected);
  EXPECT_LT((added - expected).norm(), 1e-12 * expected.norm());
}

struct Everything {
  std::vector<double> gradient, approach, multiplier, product, solution;
  double force, curvature;
  bool operator==(const Everything&) const = default;
};

template <class Real>
Everything computed(const Problem& p, const Solution& at, const std::vector<double>& v) {
  Linearised<Real> l(p, at);
  l.matrix.damp(0.1);
  Everything all{l.gradient.values(), l.gradient.approach(), l.gradient.multiplier(), {}, {}, 0.0, 0.0};
  all.force = l.gradient.residual(l.penalty).force;
  const Motions<Real> in = motions_of<Real>(vector_of(v));
  Motions<Real> out(in.size());
  all.curvature = l.matrix.apply(std::span<const Motion<Real>>(in), std::span<Motion<Real>>(out));
  const Eigen::VectorXd values = testing::vector_of(out);
  all.product.assign(values.begin(), values.end());
  const BlockJacobi<Real> jacobi(l.matrix);
  conjugate_gradients<Real>(l.matrix, {&jacobi, nullptr}, v, all.solution, {1e-4, 50});
  return all;
}

template <class Real>
void expect_same_bits(const Problem& p, const Solution& at, const std::vector<double>& v) {
  const int before = threads();
  std::vector<Everything> found;
  for (const int count : {1, 2, 4}) {
    set_threads(count);
    found.push_back(computed<Real>(p, at, v));
  }
  set_threads(before);
  EXPECT_TRUE(found[0] == found[1]);
  EXPECT_TRUE(found[0] == found[2]);
}

TEST(ManyBlocks, GiveTheSameBitsForAnyNumberOfThreads) {
  Dice dice(7);
  const Problem p = large_problem(dice);
  const Solution at = random_solution(p, 0.01, dice);
  const std::vector<double> v = random_direction(p, dice);
  expect_same_bits<float>(p, at, v);
  expect_same_bits<double>(p, at, v);
}

}  // namespace
}  // namespace frit::solve
