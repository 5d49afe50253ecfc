#include "report/sphere_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/parallel.hpp"

namespace frit::report {
namespace {

constexpr int rays = 4;  // a pixel's edge
constexpr double infinity = std::numeric_limits<double>::infinity();

// Balls by the rows of pixels that they touch, as lists in one array.
struct RowLists {
  std::vector<std::size_t> starts;  // one more than rows
  std::vector<std::uint32_t> balls;
};

struct Span {
  int first, last;  // first > last: empty
};

class Painter {
 public:
  Painter(std::span<const Ball> balls, const PictureFrame& frame)
      : balls_(balls), frame_(frame), pixel_(2.0 * frame.half_height / frame.height), lists_(row_lists()) {}

  void paint_row(int row, std::span<Rgb> pixels) const;

 private:
  struct Hit {
    double depth = infinity;
    std::uint32_t ball = 0;
  };

  double x_of(int column) const { return (column + 0.5) * pixel_ / rays - 0.5 * pixel_ * frame_.width; }
  double y_of(int line) const { return frame_.half_height - (line + 0.5) * pixel_ / rays; }
  Span rows_of(const Ball& ball) const;
  RowLists row_lists() const;
  void trace(const Ball& ball, std::uint32_t index, int line, std::span<Hit> hits) const;
  Vec3 shade(const Hit& hit, double x, double y) const;

  std::span<const Ball> balls_;
  const PictureFrame& frame_;
  double pixel_;  // edge
  RowLists lists_;
};

Span Painter::rows_of(const Ball& ball) const {
  const double top = (frame_.half_height - ball.centre.y() - ball.radius) / pixel_;
  const double bottom = (frame_.half_height - ball.centre.y() + ball.radius) / pixel_;
  const double rows = frame_.height;
  if (bottom < 0.0 || top >= rows) return {0, -1};
  return {static_cast<int>(std::max(0.0, std::floor(top))),
          static_cast<int>(std::min(rows - 1.0, std::floor(bottom)))};
}

RowLists Painter::row_lists() const {
  RowLists lists;
  lists.starts.assign(static_cast<std::size_t>(frame_.height) + 1, 0);
  for (const Ball& ball : balls_) {
    const Span rows = rows_of(ball);
    for (int row = rows.first; row <= rows.last; ++row) ++lists.starts[static_cast<std::size_t>(row) + 1];
  }
  for (std::size_t row = 1; row < lists.starts.size(); ++row) lists.starts[row] += lists.starts[row - 1];
  lists.balls.resize(lists.starts.back());
  std::vector<std::size_t> next(lists.starts.begin(), lists.starts.end() - 1);
  for (std::size_t n = 0; n < balls_.size(); ++n) {
    const Span rows = rows_of(balls_[n]);
    for (int row = rows.first; row <= rows.last; ++row) {
      lists.balls[next[static_cast<std::size_t>(row)]++] = static_cast<std::uint32_t>(n);
    }
  }
  return lists;
}

void Painter::trace(const Ball& ball, std::uint32_t index, int line, std::span<Hit> hits) const {
  const double dy = y_of(line) - ball.centre.y();
  const double reach = ball.radius * ball.radius - dy * dy;
  if (reach <= 0.0) return;
  const double half = std::sqrt(reach), step = pixel_ / rays;
  const double left = 0.5 * pixel_ * frame_.width + ball.centre.x();
  const int last =
      std::min(frame_.width * rays - 1, static_cast<int>(std::floor((left + half) / step - 0.5)));
  for (int column = std::max(0, static_cast<int>(std::ceil((left - half) / step - 0.5))); column <= last;
       ++column) {
    const double dx = x_of(column) - ball.centre.x();
    const double depth = ball.centre.z() - std::sqrt(std::max(0.0, reach - dx * dx));
    Hit& hit = hits[static_cast<std::size_t>(column)];
    if (depth < hit.depth) hit = {depth, index};
  }
}

// The light of the page's 3D view (web/src/shaders.ts), 0 to 1 a colour.
Vec3 Painter::shade(const Hit& hit, double x, double y) const {
  if (hit.depth == infinity) return Vec3::Ones();
  const Ball& ball = balls_[hit.ball];
  const Vec3 normal =
      Vec3(x - ball.centre.x(), y - ball.centre.y(), ball.centre.z() - hit.depth) / ball.radius;
  static const Vec3 sun = Vec3(-0.35, 0.55, 0.75).normalized();
  const double light = 0.42 + 0.5 * std::max(0.0, normal.dot(sun)) + 0.12 * normal.y();
  const double far = std::clamp((hit.depth - frame_.nearest) / (frame_.farthest - frame_.nearest), 0.0, 1.0);
  const double haze = 0.45 * far * far;
  // Darker within two pixels of the rim, so that neighbours of one colour are told apart.
  const double from_rim = (1.0 - std::hypot(normal.x(), normal.y())) * ball.radius / pixel_;
  const double rim = 1.0 - 0.55 * std::clamp(1.0 - from_rim / 2.0, 0.0, 1.0);
  const Vec3 colour = Vec3(ball.colour[0], ball.colour[1], ball.colour[2]) / 255.0;
  return (rim * ((1.0 - haze) * light * colour + haze * Vec3::Ones())).cwiseMin(1.0).cwiseMax(0.0);
}

void Painter::paint_row(int row, std::span<Rgb> pixels) const {
  const auto across = static_cast<std::size_t>(frame_.width) * rays;
  std::vector<Vec3> sums(pixels.size(), Vec3::Zero());
  std::vector<Hit> hits(across);
  const auto index = static_cast<std::size_t>(row);
  for (int line = row * rays; line < (row + 1) * rays; ++line) {
    std::fill(hits.begin(), hits.end(), Hit{});
    for (std::size_t n = lists_.starts[index]; n < lists_.starts[index + 1]; ++n) {
      trace(balls_[lists_.balls[n]], lists_.balls[n], line, hits);
    }
    for (std::size_t column = 0; column < across; ++column) {
      sums[column / rays] += shade(hits[column], x_of(static_cast<int>(column)), y_of(line));
    }
  }
  for (std::size_t n = 0; n < pixels.size(); ++n) {
    for (std::size_t c = 0; c < 3; ++c) {
      pixels[n][c] =
          static_cast<std::uint8_t>(std::lround(255.0 / (rays * rays) * sums[n][static_cast<int>(c)]));
    }
  }
}

}  // namespace

Image draw_balls(std::span<const Ball> balls, const PictureFrame& frame) {
  const auto width = static_cast<std::size_t>(frame.width), height = static_cast<std::size_t>(frame.height);
  Image image{frame.width, frame.height, std::vector<Rgb>(width * height)};
  const Painter painter(balls, frame);
  parallel_for(height, [&](std::size_t row) {
    painter.paint_row(static_cast<int>(row), std::span(image.pixels).subspan(row * width, width));
  });
  return image;
}

}  // namespace frit::report
