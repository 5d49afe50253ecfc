#include "report/plot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace frit::report {
namespace {

constexpr Rgb quiet{93, 99, 107}, faint{232, 234, 236};

struct Axis {
  double least, most;
  AxisKind kind;

  bool accepts(double value) const {
    return std::isfinite(value) && (kind == AxisKind::linear || value > 0.0);
  }
  double place(double value) const {
    if (kind == AxisKind::logarithmic) return std::log(value / least) / std::log(most / least);
    return (value - least) / (most - least);
  }
};

class Range {
 public:
  void widen(const std::vector<double>& values, AxisKind kind) {
    for (const double value : values) {
      if (!std::isfinite(value) || (kind == AxisKind::logarithmic && value <= 0.0)) continue;
      least_ = std::min(least_, value);
      most_ = std::max(most_, value);
    }
  }
  // With some room at both ends; zero stays the floor of what is never negative.
  Axis axis(AxisKind kind, double room) const {
    if (!(least_ <= most_)) return {kind == AxisKind::linear ? 0.0 : 1.0, 10.0, kind};
    if (kind == AxisKind::logarithmic) {
      const double factor = least_ == most_ ? 2.0 : std::pow(most_ / least_, room);
      return {least_ / factor, most_ * factor, kind};
    }
    double more = room * (most_ - least_);
    if (least_ == most_) more = least_ == 0.0 ? 1.0 : 0.05 * std::abs(least_);
    return {least_ == 0.0 ? 0.0 : least_ - more, most_ + more, kind};
  }

 private:
  double least_ = std::numeric_limits<double>::infinity(), most_ = -least_;
};

class PlotDrawing {
 public:
  PlotDrawing(Canvas& canvas, const Plot& plot, const Box& box, double unit)
      : canvas_(canvas),
        plot_(plot),
        unit_(unit),
        left_(box.top_left.x + 5.6 * unit),
        right_(box.bottom_right.x - 1.2 * unit),
        top_(box.top_left.y + 2.6 * unit),
        bottom_(box.bottom_right.y - 3.6 * unit),
        x_(axis_of_x()),
        y_(axis_of_y()) {}

  void draw() {
    draw_axes();
    canvas_.clip({left_, top_ - 0.3 * unit_}, {right_ + 0.3 * unit_, bottom_ + 0.3 * unit_});
    for (const PlotCurve& curve : plot_.curves) draw_curve(curve);
    canvas_.clip_nothing();
  }

 private:
  Axis axis_of_x() const {
    Range range;
    for (const PlotCurve& curve : plot_.curves) range.widen(curve.x, AxisKind::linear);
    return range.axis(AxisKind::linear, 0.0);
  }
  Axis axis_of_y() const {
    Range range;
    for (const PlotCurve& curve : plot_.curves) {
      for (const auto* values : {&curve.y, &curve.low, &curve.high}) range.widen(*values, plot_.y_kind);
    }
    return range.axis(plot_.y_kind, 0.05);
  }
  double px(double x) const { return left_ + x_.place(x) * (right_ - left_); }
  double py(double y) const { return bottom_ - y_.place(y) * (bottom_ - top_); }

  void draw_axes() {
    const Pen grid{faint, 0.08 * unit_, 1.0};
    const TextStyle small{.size = unit_, .align = Align::centre, .colour = quiet};
    for (const double tick : ticks(x_.least, x_.most, 6.0, x_.kind)) {
      canvas_.line({{px(tick), top_}, {px(tick), bottom_}}, grid);
      canvas_.text(tick_text(tick), {px(tick), bottom_ + 1.4 * unit_}, small);
    }
    TextStyle beside = small;
    beside.align = Align::right;
    for (const double tick : ticks(y_.least, y_.most, 5.0, y_.kind)) {
      canvas_.line({{left_, py(tick)}, {right_, py(tick)}}, grid);
      canvas_.text(tick_text(tick), {left_ - 0.6 * unit_, py(tick) + 0.35 * unit_}, beside);
    }
    canvas_.line({{left_, top_}, {left_, bottom_}, {right_, bottom_}}, {quiet, 0.1 * unit_, 1.0});
    canvas_.text(plot_.title, {left_, top_ - 0.9 * unit_}, {.size = 1.1 * unit_, .bold = true});
    TextStyle label{.size = unit_, .align = Align::centre};
    canvas_.text(plot_.x_label, {0.5 * (left_ + right_), bottom_ + 3.0 * unit_}, label);
    label.upwards = true;
    canvas_.text(plot_.y_label, {left_ - 4.4 * unit_, 0.5 * (top_ + bottom_)}, label);
  }

  void draw_curve(const PlotCurve& curve) {
    std::vector<Point> there, back, line;
    for (std::size_t n = 0; n < curve.x.size(); ++n) {
      if (!x_.accepts(curve.x[n])) continue;
      if (n < curve.low.size() && y_.accepts(curve.low[n]) && y_.accepts(curve.high[n])) {
        there.push_back({px(curve.x[n]), py(curve.high[n])});
        back.push_back({px(curve.x[n]), py(curve.low[n])});
      }
      if (y_.accepts(curve.y[n])) line.push_back({px(curve.x[n]), py(curve.y[n])});
    }
    there.insert(there.end(), back.rbegin(), back.rend());
    canvas_.area(there, {curve.colour, 0.0, 0.16});
    canvas_.line(line, {curve.colour, 0.16 * unit_, 1.0});
    if (line.size() > 80) return;
    for (const Point& point : line) canvas_.disc(point, 0.18 * unit_, {curve.colour, 0.0, 1.0});
  }

  Canvas& canvas_;
  const Plot& plot_;
  double unit_, left_, right_, top_, bottom_;
  Axis x_, y_;
};

}  // namespace

std::vector<double> ticks(double least, double most, double about, AxisKind kind) {
  std::vector<double> places;
  if (!(most > least)) return places;
  if (kind == AxisKind::logarithmic && most / least > 16.0) {
    const double powers = std::log10(most / least);
    const double every = std::ceil(powers / about);
    for (double power = std::ceil(std::log10(least) - 1e-9); power <= std::log10(most) + 1e-9;
         power += every) {
      places.push_back(std::pow(10.0, power));
    }
    return places;
  }
  const double wanted = (most - least) / about, power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.5, 2.0, 1.0}) {
    if (factor * power >= 0.999 * wanted) step = factor * power;
  }
  for (double n = std::ceil(least / step - 1e-9); n * step <= most + 1e-9 * (most - least); n += 1.0) {
    places.push_back(n * step);
  }
  return places;
}

std::string tick_text(double value) { return fmt::format("{:.4g}", value == 0.0 ? 0.0 : value); }

void draw_plot(Canvas& canvas, const Plot& plot, const Box& box, double unit) {
  PlotDrawing(canvas, plot, box, unit).draw();
}

}  // namespace frit::report
