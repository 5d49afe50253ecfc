#include "analyze/line_plot.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "io/xml_scan.hpp"

namespace frit::analyze {
namespace {

constexpr double width = 640.0, height = 400.0;
constexpr double left = 72.0, right = 16.0, top = 16.0, bottom = 52.0;  // margins
constexpr double legend_line = 18.0;
constexpr std::size_t styles = 6;

// Colours that the colour-blind tell apart (Okabe & Ito 2008), lighter ones on dark pages.
constexpr const char* style_sheet = R"(<style>
svg { --paper: #ffffff; --ink: #222222; --grid: #dddddd; color-scheme: light dark; }
.s0 { --c: #0072b2; } .s1 { --c: #d55e00; } .s2 { --c: #009e73; }
.s3 { --c: #b8578c; } .s4 { --c: #8a6d00; } .s5 { --c: #444444; }
@media (prefers-color-scheme: dark) {
  svg { --paper: #16181c; --ink: #e6e6e6; --grid: #3a3d44; }
  .s0 { --c: #56b4e9; } .s1 { --c: #ff8c42; } .s2 { --c: #3fd0a4; }
  .s3 { --c: #e69ac4; } .s4 { --c: #f0e442; } .s5 { --c: #bbbbbb; }
}
text { fill: var(--ink); font: 13px system-ui, sans-serif; }
.grid { stroke: var(--grid); stroke-width: 1; }
.axis { stroke: var(--ink); stroke-width: 1; fill: none; }
.line { stroke: var(--c); stroke-width: 2; fill: none; }
.mark { stroke: var(--c); stroke-width: 1.5; fill: var(--paper); }
.s1 .line, .line.s1 { stroke-dasharray: 8 3; } .s2 .line, .line.s2 { stroke-dasharray: 2 3; }
.s3 .line, .line.s3 { stroke-dasharray: 8 3 2 3; } .s4 .line, .line.s4 { stroke-dasharray: 14 4; }
.s5 .line, .line.s5 { stroke-dasharray: 5 5; }
</style>
)";

struct Axis {
  double low = 0.0, high = 1.0;  // of the values, or of their decimal logarithms
  Scale scale = Scale::linear;
  double begin = 0.0, end = 1.0;  // in the picture

  bool takes(double value) const { return std::isfinite(value) && (scale == Scale::linear || value > 0.0); }
  double place(double value) const {
    const double shown = scale == Scale::linear ? value : std::log10(value);
    return begin + (shown - low) / (high - low) * (end - begin);
  }
};

struct Frame {
  Axis x, y;
};

struct Tick {
  double value;
  std::string text;
};

std::vector<Tick> linear_ticks(const Axis& axis) {
  const double wanted = (axis.high - axis.low) / 7.0, power = std::pow(10.0, std::floor(std::log10(wanted)));
  double step = 10.0 * power;
  for (const double factor : {5.0, 2.0, 1.0})
    if (factor * power >= wanted) step = factor * power;
  std::vector<Tick> ticks;
  for (double n = std::ceil(axis.low / step - 1e-9); n * step <= axis.high + 1e-9 * step; n += 1.0)
    ticks.push_back({n * step, fmt::format("{:.6g}", n == 0.0 ? 0.0 : n * step)});
  return ticks;
}

std::vector<Tick> decade_ticks(const Axis& axis) {
  const int first = static_cast<int>(std::ceil(axis.low - 1e-9)),
            last = static_cast<int>(std::floor(axis.high + 1e-9));
  const int step = std::max(1, (last - first) / 8 + 1);
  std::vector<Tick> ticks;
  for (int decade = first; decade <= last; decade += step)
    ticks.push_back({std::pow(10.0, decade), fmt::format("1e{}", decade)});
  return ticks;
}

std::vector<Tick> ticks_of(const Axis& axis) {
  return axis.scale == Scale::linear ? linear_ticks(axis) : decade_ticks(axis);
}

// The axis from the least to the largest value, and a little more where it is linear.
template <class Values>
void fit(Axis& axis, const std::vector<Line>& lines, Values&& values_of) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Line& line : lines) {
    for (const double value : values_of(line)) {
      if (!axis.takes(value)) continue;
      const double shown = axis.scale == Scale::linear ? value : std::log10(value);
      low = std::min(low, shown);
      high = std::max(high, shown);
    }
  }
  if (!(low <= high)) return;
  const double room = high > low ? 0.04 * (high - low) : 0.5 * std::max(std::abs(high), 1e-300);
  axis.low = low - room;
  axis.high = high + room;
}

// Text whose bytes stand for themselves in XML.
std::string text_at(double x, double y, const std::string& text, const char* more) {
  return fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" {}>{}</text>\n", x, y, more, io::escape_xml(text));
}

std::string axes(const Frame& frame, const LinePlot& plot) {
  std::string svg;
  for (const Tick& tick : ticks_of(frame.x)) {
    const double x = frame.x.place(tick.value);
    svg +=
        fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:.1f}V{2:.1f}\"/>\n", x, frame.y.begin, frame.y.end);
    svg += text_at(x, frame.y.begin + 18.0, tick.text, "text-anchor=\"middle\"");
  }
  for (const Tick& tick : ticks_of(frame.y)) {
    const double y = frame.y.place(tick.value);
    svg +=
        fmt::format("<path class=\"grid\" d=\"M{0:.1f} {1:.1f}H{2:.1f}\"/>\n", frame.x.begin, y, frame.x.end);
    svg += text_at(frame.x.begin - 8.0, y + 4.0, tick.text, "text-anchor=\"end\"");
  }
  svg += fmt::format("<path class=\"axis\" d=\"M{0:.1f} {1:.1f}V{2:.1f}H{3:.1f}\"/>\n", frame.x.begin,
                     frame.y.end, frame.y.begin, frame.x.end);
  const double middle_x = 0.5 * (frame.x.begin + frame.x.end), middle_y = 0.5 * (frame.y.begin + frame.y.end);
  svg += text_at(middle_x, frame.y.begin + 40.0, plot.x_label, "text-anchor=\"middle\"");
  return svg +
         text_at(16.0, middle_y, plot.y_label,
                 fmt::format("text-anchor=\"middle\" transform=\"rotate(-90 16 {:.1f})\"", middle_y).c_str());
}

// A different shape for each style: disc, square, diamond, triangle.
std::string marker(std::size_t style, double x, double y) {
  switch (style % 4) {
    case 0:
      return fmt::format("<circle class=\"mark\" cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"3.5\"/>\n", x, y);
    case 1:
      return fmt::format("<path class=\"mark\" d=\"M{:.1f} {:.1f}h6.4v6.4h-6.4z\"/>\n", x - 3.2, y - 3.2);
    case 2:
      return fmt::format("<path class=\"mark\" d=\"M{:.1f} {:.1f}l4.2 4.2l-4.2 4.2l-4.2 -4.2z\"/>\n", x,
                         y - 4.2);
    default:
      return fmt::format("<path class=\"mark\" d=\"M{:.1f} {:.1f}l4.2 7.4h-8.4z\"/>\n", x, y - 4.6);
  }
}

std::string drawn(const Frame& frame, const Line& line, std::size_t style) {
  std::string path, marks;
  bool is_open = false;
  std::size_t points = 0;
  for (std::size_t n = 0; n < line.x.size(); ++n) {
    const bool known = frame.x.takes(line.x[n]) && frame.y.takes(line.y[n]);
    if (known) {
      const double x = frame.x.place(line.x[n]), y = frame.y.place(line.y[n]);
      path += fmt::format("{}{:.1f} {:.1f}", is_open ? "L" : "M", x, y);
      // Markers on a few points only; they tell lines apart, they are no data.
      if (points++ % std::max<std::size_t>(1, line.x.size() / 8) == 0) marks += marker(style, x, y);
    }
    is_open = known;
  }
  return fmt::format("<g class=\"s{}\"><path class=\"line\" d=\"{}\"/>\n{}</g>\n", style % styles, path,
                     marks);
}

std::string legend(const LinePlot& plot, double y) {
  std::string svg;
  for (std::size_t n = 0; n < plot.lines.size(); ++n, y += legend_line) {
    svg += fmt::format("<g class=\"s{}\"><path class=\"line\" d=\"M{:.1f} {:.1f}h34\"/>\n{}</g>\n",
                       n % styles, left, y, marker(n, left + 17.0, y));
    svg += text_at(left + 42.0, y + 4.5, plot.lines[n].name, "");
  }
  return svg;
}

}  // namespace

std::string draw(const LinePlot& plot) {
  Frame frame{{0.0, 1.0, plot.x_scale, left, width - right}, {0.0, 1.0, Scale::linear, height - bottom, top}};
  fit(frame.x, plot.lines, [](const Line& line) { return line.x; });
  fit(frame.y, plot.lines, [](const Line& line) { return line.y; });
  const double whole = height + legend_line * static_cast<double>(plot.lines.size());
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\" "
      "role=\"img\">\n"
      "<title>{2} against {3}</title>\n{4}<rect width=\"{0}\" height=\"{1}\" fill=\"var(--paper)\"/>\n",
      width, whole, io::escape_xml(plot.y_label), io::escape_xml(plot.x_label), style_sheet);
  svg += axes(frame, plot);
  for (std::size_t n = 0; n < plot.lines.size(); ++n) svg += drawn(frame, plot.lines[n], n);
  return svg + legend(plot, height) + "</svg>\n";
}

}  // namespace frit::analyze
