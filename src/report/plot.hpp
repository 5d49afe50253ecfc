// Curves on a canvas: axes with ticks, lines, bands.
#pragma once

#include <string>
#include <vector>

#include "report/canvas.hpp"

namespace frit::report {

struct PlotCurve {
  Rgb colour;
  std::vector<double> x, y;
  std::vector<double> low, high;  // of a band, or empty
};

enum class AxisKind { linear, logarithmic };

struct Plot {
  std::string title, x_label, y_label;
  AxisKind y_kind = AxisKind::linear;
  std::vector<PlotCurve> curves;
};

struct Box {
  Point top_left, bottom_right;
};

// Places of ticks from `least` to `most`: whole multiples of 1, 2, 2.5 or 5 times a power of ten, about
// `about` of them; powers of ten on a logarithmic axis that spans more than one.
std::vector<double> ticks(double least, double most, double about, AxisKind kind);

// Few digits: "0.65", "1e-5".
std::string tick_text(double value);

// Draws into the box; `unit` is the size of its text [pixels]. What is not finite is left out.
void draw_plot(Canvas& canvas, const Plot& plot, const Box& box, double unit);

}  // namespace frit::report
