#include "solve/sparse_cholesky.hpp"

#include <algorithm>
#include <numeric>

#include "core/contract.hpp"
#include "core/parallel.hpp"
#include "solve/front_solve.hpp"

namespace frit::solve {
namespace {

constexpr std::size_t leaf_unknowns = 40;  // largest leaf: fewer fill the factor less, more make longer loops
constexpr double factor_grain = 2e6;       // flops below which a subtree is not worth a task
constexpr double solve_grain = 4e7;        // the same for a substitution

enum class Order { leaves_first, roots_first };

// Visits every front below `fronts`, and those, children before parents or the other way round.
template <Order order, class Visit>
class Walk {
 public:
  Walk(const FrontTree& tree, std::span<const double> work, double grain, const Visit& visit)
      : tree_(tree), work_(work), grain_(grain), visit_(visit) {}

  void over(std::span<const std::int32_t> fronts) const {
    if (fronts.size() > 1 && total(fronts) > grain_) {
      const std::size_t half = fronts.size() / 2;
      run_both([&] { over(fronts.first(half)); }, [&] { over(fronts.subspan(half)); });
      return;
    }
    for (const std::int32_t front : fronts) {
      if (order == Order::roots_first) visit_(front);
      over(tree_.children_of(front));
      if (order == Order::leaves_first) visit_(front);
    }
  }

 private:
  double total(std::span<const std::int32_t> fronts) const {
    double sum = 0.0;
    for (const std::int32_t front : fronts) sum += work_[front];
    return sum;
  }

  const FrontTree& tree_;
  std::span<const double> work_;
  double grain_;
  const Visit& visit_;
};

template <Order order, class Visit>
void walk(const FrontTree& tree, std::span<const double> work, double grain, const Visit& visit) {
  Walk<order, Visit>(tree, work, grain, visit).over(tree.roots);
}

FrontTree analyse(std::size_t width, std::span<const Vec3> positions,
                  std::span<const std::array<std::int32_t, 2>> links) {
  FRIT_EXPECT(width > 0);
  const Adjacency graph = adjacency(positions.size(), links);
  const std::size_t leaf_bodies = std::max<std::size_t>(1, leaf_unknowns / width);
  return front_tree(dissect(positions, graph, leaf_bodies), graph, links);
}

void add_block(DenseBlock panel, const FrontEntry& at, std::size_t width, const double* block) {
  const auto size = static_cast<Eigen::Index>(width);
  const Eigen::Map<const Eigen::MatrixXd> given(block, size, size);
  for (Eigen::Index column = 0; column < size; ++column) {
    for (Eigen::Index row = 0; row < size; ++row) {
      panel(at.row * size + row, at.column * size + column) +=
          at.is_turned ? given(column, row) : given(row, column);
    }
  }
}

// For every entry of an ascending list, the end of the run of consecutive numbers it belongs to.
std::vector<std::size_t> run_ends(std::span<const std::int32_t> places) {
  std::vector<std::size_t> ends(places.size(), places.size());
  for (std::size_t n = places.size(); n-- > 1;) {
    ends[n - 1] = places[n - 1] + 1 == places[n] ? ends[n] : n;
  }
  return ends;
}

}  // namespace

SparseCholesky::SparseCholesky(int width, std::span<const Vec3> positions,
                               std::span<const std::array<std::int32_t, 2>> links, FactorPrecision kept)
    : width_(static_cast<std::size_t>(width)), kept_(kept), tree_(analyse(width_, positions, links)) {
  plan();
}

void SparseCholesky::plan() {
  // Eigen cuts its products by the caches it finds: fixed sizes make the sums those of every machine.
  Eigen::setCpuCacheSizes(32 << 10, 1 << 20, 4 << 20);
  const auto fronts = static_cast<std::size_t>(tree_.fronts());
  panel_start_.assign(1, 0);
  work_.assign(fronts, 0.0);
  rest_.resize(fronts);
  dropped_.assign(fronts, 0);
  for (std::int32_t front = 0; front < tree_.fronts(); ++front) {
    const std::size_t own = columns(front), rows = own + boundary_rows(front);
    panel_start_.push_back(panel_start_.back() + rows * own);
    for (std::size_t row = rows - own + 1; row <= rows; ++row) work_[front] += static_cast<double>(row * row);
    for (const std::int32_t child : tree_.children_of(front)) work_[front] += work_[child];
  }
  if (kept_ == FactorPrecision::full) {
    factor_ = std::make_unique_for_overwrite<double[]>(panel_start_.back());
  } else {
    single_factor_ = std::make_unique_for_overwrite<float[]>(panel_start_.back());
  }
  own_.assign(unknowns(), 0.0);
  carried_.assign(width_ * tree_.boundary.size(), 0.0);
}

FactorReport SparseCholesky::factor(const BlockValues& values, double threshold) {
  FRIT_EXPECT(values.diagonal.size() == bodies() * width_ * width_);
  FRIT_EXPECT(values.coupling.size() == tree_.entries.size() * width_ * width_);
  walk<Order::leaves_first>(tree_, work_, factor_grain,
                            [&](std::int32_t front) { factor_front(front, values, threshold); });
  return {std::accumulate(dropped_.begin(), dropped_.end(), std::size_t{0})};
}

DenseBlock SparseCholesky::rest_of(std::int32_t front) {
  const auto rows = static_cast<Eigen::Index>(boundary_rows(front));
  return {rest_[front].get(), rows, rows, Eigen::OuterStride<>(rows)};
}

void SparseCholesky::factor_front(std::int32_t front, const BlockValues& values, double threshold) {
  const std::size_t own = columns(front), rest = boundary_rows(front), rows = own + rest;
  std::unique_ptr<double[]> scratch;
  if (kept_ == FactorPrecision::single) scratch = std::make_unique_for_overwrite<double[]>(rows * own);
  double* numbers = scratch ? scratch.get() : factor_.get() + panel_start_[front];
  const auto stride = static_cast<Eigen::Index>(rows);
  const DenseBlock panel(numbers, stride, static_cast<Eigen::Index>(own), Eigen::OuterStride<>(stride));
  assemble(front, values, panel);

  std::vector<double> smallest_pivot(own);
  for (std::size_t column = 0; column < own; ++column) {
    const auto body = static_cast<std::size_t>(tree_.order[tree_.first[front] + column / width_]);
    const std::size_t component = column % width_;
    smallest_pivot[column] = threshold * values.diagonal[(body * width_ + component) * width_ + component];
  }
  dropped_[front] = factor_panel(panel, smallest_pivot);
  if (rest > 0) {
    const auto below = static_cast<Eigen::Index>(rest);
    subtract_square(rest_of(front),
                    DenseBlock(numbers + own, below, panel.cols(), Eigen::OuterStride<>(stride)));
  }
  if (scratch) std::copy_n(numbers, rows * own, single_factor_.get() + panel_start_[front]);
}

// Only what lies on or below the diagonal blocks means anything in a front.
void SparseCholesky::assemble(std::int32_t front, const BlockValues& values, DenseBlock panel) {
  panel.setZero();
  const std::size_t rows = boundary_rows(front), block = width_ * width_;
  rest_[front] = std::make_unique_for_overwrite<double[]>(rows * rows);
  for (std::size_t column = 0; column < rows; ++column) {
    const std::size_t top = column / width_ * width_;
    std::fill_n(rest_[front].get() + column * rows + top, rows - top, 0.0);
  }
  for (std::int32_t place = 0; place < tree_.own(front); ++place) {
    const auto body = static_cast<std::size_t>(tree_.order[tree_.first[front] + place]);
    add_block(panel, {0, place, place, false}, width_, values.diagonal.data() + block * body);
  }
  for (const FrontEntry& entry : tree_.entries_of(front)) {
    add_block(panel, entry, width_, values.coupling.data() + block * static_cast<std::size_t>(entry.link));
  }
  for (const std::int32_t child : tree_.children_of(front)) add_child(front, child, panel);
}

// Extend-add; the child's rows are ascending in the parent, and many are consecutive there.
void SparseCholesky::add_child(std::int32_t front, std::int32_t child, DenseBlock panel) {
  const std::span<const std::int32_t> places = tree_.places_of(child);
  const std::vector<std::size_t> ends = run_ends(places);
  const std::size_t own = columns(front), rest = boundary_rows(front), given = boundary_rows(child);
  for (std::size_t n = 0; n < places.size(); ++n) {
    for (std::size_t component = 0; component < width_; ++component) {
      const double* from = rest_[child].get() + (n * width_ + component) * given;
      const std::size_t column = places[n] * width_ + component, above = column < own ? 0 : own;
      double* to =
          column < own ? panel.data() + column * (own + rest) : rest_[front].get() + (column - own) * rest;
      for (std::size_t run = n; run < places.size(); run = ends[run]) {
        double* target = to + (places[run] * width_ - above);
        const double* source = from + run * width_;
        const std::size_t length = (ends[run] - run) * width_;
        for (std::size_t row = 0; row < length; ++row) target[row] += source[row];
      }
    }
  }
  rest_[child].reset();
}

void SparseCholesky::solve(std::span<const double> in, std::span<double> out) {
  FRIT_EXPECT(in.size() == unknowns() && out.size() == unknowns());
  const auto copy_bodies = [&](const auto& copy) {
    parallel_for(bodies(), [&](std::size_t rank) {
      copy(rank * width_, static_cast<std::size_t>(tree_.order[rank]) * width_);
    });
  };
  copy_bodies([&](std::size_t own, std::size_t given) {
    std::copy_n(in.begin() + static_cast<std::ptrdiff_t>(given), width_, own_.data() + own);
  });
  walk<Order::leaves_first>(tree_, work_, solve_grain, [&](std::int32_t front) { carry_forward(front); });
  walk<Order::roots_first>(tree_, work_, solve_grain, [&](std::int32_t front) { carry_backward(front); });
  copy_bodies([&](std::size_t own, std::size_t given) {
    std::copy_n(own_.data() + own, width_, out.begin() + static_cast<std::ptrdiff_t>(given));
  });
}

void SparseCholesky::carry_forward(std::int32_t front) {
  double* own = own_.data() + width_ * tree_.first[front];
  double* rest = carried_.data() + width_ * tree_.boundary_start[front];
  std::fill_n(rest, boundary_rows(front), 0.0);
  for (const std::int32_t child : tree_.children_of(front)) {
    const double* given = carried_.data() + width_ * tree_.boundary_start[child];
    for (const std::int32_t place : tree_.places_of(child)) {
      double* to =
          place < tree_.own(front) ? own + place * width_ : rest + (place - tree_.own(front)) * width_;
      for (std::size_t component = 0; component < width_; ++component) to[component] += *given++;
    }
  }
  const FrontVectors vectors{own, rest, columns(front), boundary_rows(front)};
  if (factor_) {
    solve_forward(factor_.get() + panel_start_[front], vectors);
  } else {
    solve_forward(single_factor_.get() + panel_start_[front], vectors);
  }
}

void SparseCholesky::carry_backward(std::int32_t front) {
  double* rest = carried_.data() + width_ * tree_.boundary_start[front];
  double* next = rest;
  for (const std::int32_t rank : tree_.boundary_of(front)) {
    next = std::copy_n(own_.data() + width_ * rank, width_, next);
  }
  const FrontVectors vectors{own_.data() + width_ * tree_.first[front], rest, columns(front),
                             boundary_rows(front)};
  if (factor_) {
    solve_backward(factor_.get() + panel_start_[front], vectors);
  } else {
    solve_backward(single_factor_.get() + panel_start_[front], vectors);
  }
}

FactorSize SparseCholesky::size() const {
  const std::size_t entries = panel_start_.back();
  std::size_t bytes = entries * (factor_ ? sizeof(double) : sizeof(float));
  bytes += sizeof(double) * (own_.size() + carried_.size() + work_.size());
  bytes += sizeof(std::int32_t) *
           (tree_.order.size() + tree_.first.size() + tree_.children.size() + 2 * tree_.boundary.size());
  bytes += sizeof(FrontEntry) * tree_.entries.size() + sizeof(std::size_t) * 5 * tree_.first.size();
  double flops = 0.0;
  for (const std::int32_t root : tree_.roots) flops += work_[root];
  return {entries, bytes, flops};
}

}  // namespace frit::solve
