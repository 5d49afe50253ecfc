// A plot of lines as SVG: axes with round ticks, units, a legend; readable on light and dark pages and
// without colours.
#pragma once

#include <string>
#include <vector>

namespace frit::analyze {

enum class Scale { linear, logarithmic };

struct Line {
  std::string name;
  std::vector<double> x,
      y;  // of one length; points with a NaN, or x <= 0 on a logarithmic axis, are left out
};

struct LinePlot {
  std::string x_label, y_label;  // with units
  Scale x_scale = Scale::linear;
  std::vector<Line> lines;
};

// The SVG document. Lines differ in colour, dash and marker.
std::string draw(const LinePlot& plot);

}  // namespace frit::analyze
