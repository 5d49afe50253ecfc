#include "solve/partial_cholesky.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <vector>

#include "solve/block_network.hpp"
#include "solve/front_solve.hpp"

namespace frit::solve {
namespace {

using namespace testing;

DenseBlock whole(Eigen::MatrixXd& matrix) {
  return {matrix.data(), matrix.rows(), matrix.cols(), Eigen::OuterStride<>(matrix.rows())};
}

DenseBlock bottom(Eigen::MatrixXd& matrix, Eigen::Index rows) {
  return {matrix.data() + matrix.rows() - rows, rows, matrix.cols(), Eigen::OuterStride<>(matrix.rows())};
}

Eigen::MatrixXd random_matrix(Eigen::Index rows, Eigen::Index columns, Dice& dice) {
  return random_vector(rows * columns, dice).reshaped(rows, columns);
}

// Lower triangle of a panel's own columns with the diagonal that its reciprocals stand for.
Eigen::MatrixXd lower_of(const Eigen::MatrixXd& panel) {
  Eigen::MatrixXd lower = panel.topRows(panel.cols()).triangularView<Eigen::Lower>();
  for (double& value : lower.diagonal()) value = value == 0.0 ? 0.0 : 1.0 / value;
  return lower;
}

struct Shape {
  Eigen::Index rows, columns;
};
constexpr Shape shapes[] = {{1, 1},   {3, 3},   {17, 5},   {18, 17},  {19, 17},
                            {20, 20}, {60, 33}, {130, 45}, {900, 70}, {460, 430}};

TEST(PartialCholesky, FactorsItsColumnsAndLeavesTheSchurComplement) {
  Dice dice(1);
  for (const auto [rows, columns] : shapes) {
    const Eigen::MatrixXd root = random_matrix(rows, rows, dice);
    const Eigen::MatrixXd full = root * root.transpose() + Eigen::MatrixXd::Identity(rows, rows);
    const Eigen::Index rest = rows - columns;
    Eigen::MatrixXd panel = full.leftCols(columns), square = full.bottomRightCorner(rest, rest);
    const std::vector<double> smallest(static_cast<std::size_t>(columns), 0.0);
    EXPECT_EQ(factor_panel(whole(panel), smallest), 0U);
    subtract_square(whole(square), bottom(panel, rest));

    const Eigen::MatrixXd exact = full.llt().matrixL();
    EXPECT_LT((lower_of(panel) - exact.topLeftCorner(columns, columns)).norm(), 1e-10 * exact.norm());
    EXPECT_LT((panel.bottomRows(rest) - exact.bottomLeftCorner(rest, columns)).norm(), 1e-10 * exact.norm());
    const Eigen::MatrixXd left = exact.bottomRightCorner(rest, rest);
    const Eigen::MatrixXd complement = left * left.transpose();
    const Eigen::MatrixXd wrong = (square - complement).triangularView<Eigen::Lower>();
    EXPECT_LT(wrong.norm(), 1e-10 * full.norm());
  }
}

TEST(PartialCholesky, DropsAsManyPivotsAsTheRankLacks) {
  Dice dice(2);
  for (const Eigen::Index rank : {1, 7, 40, 95}) {
    const Eigen::MatrixXd root = random_matrix(100, rank, dice);
    const Eigen::MatrixXd full = root * root.transpose();
    Eigen::MatrixXd panel = full;
    std::vector<double> smallest;
    for (const double value : full.diagonal()) smallest.push_back(1e-10 * value);
    EXPECT_EQ(factor_panel(whole(panel), smallest), static_cast<std::size_t>(100 - rank));
    const Eigen::MatrixXd lower = lower_of(panel);
    EXPECT_LT((lower * lower.transpose() - full).norm(), 1e-8 * full.norm());
    for (Eigen::Index column = 0; column < 100; ++column) {
      EXPECT_EQ(lower(column, column) == 0.0, lower.col(column).norm() == 0.0);
    }
  }
}

TEST(PartialCholesky, RoundsTheSameWhereverTheNumbersLie) {
  Dice dice(3);
  for (const auto [rows, columns] : shapes) {
    const Eigen::MatrixXd root = random_matrix(rows, rows, dice);
    const Eigen::MatrixXd full = root * root.transpose() + Eigen::MatrixXd::Identity(rows, rows);
    const Eigen::Index rest = rows - columns;
    const std::vector<double> smallest(static_cast<std::size_t>(columns), 0.0);
    std::vector<Eigen::VectorXd> found;
    for (const Eigen::Index shift : {0, 1, 2, 3, 5}) {
      Eigen::VectorXd memory(shift + rows * columns + rest * rest);
      DenseBlock panel(memory.data() + shift, rows, columns, Eigen::OuterStride<>(rows));
      DenseBlock square(memory.data() + shift + rows * columns, rest, rest, Eigen::OuterStride<>(rest));
      panel = full.leftCols(columns);
      square = full.bottomRightCorner(rest, rest);
      factor_panel(panel, smallest);
      subtract_square(square,
                      DenseBlock(memory.data() + shift + columns, rest, columns, Eigen::OuterStride<>(rows)));
      found.emplace_back(memory.tail(memory.size() - shift));
    }
    for (const Eigen::VectorXd& other : found) EXPECT_EQ(other, found.front());
  }
}

TEST(FrontSolve, CarriesAVectorThroughTheColumns) {
  Dice dice(4);
  for (const auto [rows, columns] : shapes) {
    Eigen::MatrixXd panel = random_matrix(rows, columns, dice) / std::sqrt(static_cast<double>(rows));
    panel.diagonal().setConstant(0.5);
    const Eigen::MatrixXd lower = lower_of(panel), below = panel.bottomRows(rows - columns);
    const Eigen::VectorXd own = random_vector(columns, dice), rest = random_vector(rows - columns, dice);
    Eigen::VectorXd forward = own, forward_rest = rest, backward = own, backward_rest = rest;
    const auto count = static_cast<std::size_t>(columns), boundary = static_cast<std::size_t>(rows - columns);
    solve_forward(panel.data(), {forward.data(), forward_rest.data(), count, boundary});
    solve_backward(panel.data(), {backward.data(), backward_rest.data(), count, boundary});

    const Eigen::VectorXd exact = lower.triangularView<Eigen::Lower>().solve(own);
    EXPECT_LT((forward - exact).norm(), 1e-11 * exact.norm());
    EXPECT_LT((forward_rest - (rest - below * exact)).norm(), 1e-11 * (1.0 + exact.norm()));
    const Eigen::VectorXd reduced = own - below.transpose() * rest;
    const Eigen::VectorXd back = lower.transpose().triangularView<Eigen::Upper>().solve(reduced);
    EXPECT_LT((backward - back).norm(), 1e-11 * back.norm());
    EXPECT_EQ(backward_rest, rest);
  }
}

}  // namespace
}  // namespace frit::solve
