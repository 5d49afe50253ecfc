#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/pictures.hpp"
#include "report/plot.hpp"

namespace frit::report {
namespace {

// Okabe and Ito 2008; the page has the same (web/src/runs.ts).
constexpr std::array<Rgb, 6> run_colours{
    {{0, 114, 178}, {213, 94, 0}, {0, 158, 115}, {204, 121, 167}, {230, 159, 0}, {86, 180, 233}}};

struct Panel {
  const char *title, *x, *y, *x_label, *y_label;
  const char *low = "", *high = "";
  AxisKind y_kind = AxisKind::linear;
};

constexpr std::array<Panel, 6> panels{{
    {"Relative density", "time", "relative_density", "time [s]", "relative density"},
    {"Union density", "time", "union_density", "time [s]", "density, overlaps counted once"},
    {"Coordination", "relative_density", "coordination", "relative density", "contacts a particle"},
    {"Neck ratio, 10 to 90 %", "relative_density", "neck_ratio_mean", "relative density", "x = r/R",
     "neck_ratio_q10", "neck_ratio_q90"},
    {"Rearrangement", "relative_density", "rearrangement_pair_ratio", "relative density", "pair ratio"},
    {"Non-affine motion, 10 to 90 %", "relative_density", "rearrangement_d2min_mean", "relative density",
     "D²min/R²", "rearrangement_d2min_q10", "rearrangement_d2min_q90"},
}};

Plot plot_of(const Panel& panel, std::span<const Result> results) {
  Plot plot{panel.title, panel.x_label, panel.y_label, panel.y_kind, {}};
  for (std::size_t n = 0; n < results.size(); ++n) {
    const auto get = [&](const char* name) {
      return column(results[n].series, name).value_or(std::vector<double>{});
    };
    PlotCurve curve{run_colours[n % run_colours.size()], get(panel.x), get(panel.y), get(panel.low),
                    get(panel.high)};
    if (!curve.x.empty() && !curve.y.empty()) plot.curves.push_back(std::move(curve));
  }
  return plot;
}

void draw_names(Canvas& canvas, std::span<const Result> results, Point at, double unit) {
  const TextStyle style{.size = 1.1 * unit, .align = Align::left};
  for (std::size_t n = 0; n < results.size(); ++n) {
    canvas.disc({at.x + 0.5 * unit, at.y - 0.4 * unit}, 0.5 * unit,
                {run_colours[n % run_colours.size()], 0.0, 1.0});
    canvas.text(results[n].name, {at.x + 1.6 * unit, at.y}, style);
    at.x += canvas.text_width(results[n].name, style) + 4.0 * unit;
  }
}

}  // namespace

void write_curve_picture(std::span<const Result> results, const PictureOptions& options,
                         const std::filesystem::path& file) {
  const int width = options.width, height = width * 5 / 8;
  const double unit = width / 125.0, head = 6.0 * unit;
  Canvas canvas(width, height);
  const Result& first = results.front();
  const std::string title = results.size() > 1          ? fmt::format("{} runs", results.size())
                            : first.whole.title.empty() ? first.name
                                                        : first.whole.title;
  canvas.text(title, {2.0 * unit, 3.0 * unit}, {.size = 1.5 * unit, .bold = true});
  if (results.size() > 1) draw_names(canvas, results, {2.0 * unit, 5.2 * unit}, unit);
  const double panel_width = width / 3.0, panel_height = (height - head) / 2.0;
  for (std::size_t n = 0; n < panels.size(); ++n) {
    const std::size_t column = n % 3, row = n / 3;
    const Point corner{panel_width * static_cast<double>(column),
                       head + panel_height * static_cast<double>(row)};
    draw_plot(canvas, plot_of(panels[n], results),
              {corner, {corner.x + panel_width, corner.y + panel_height}}, unit);
  }
  canvas.write_png(file);
}

std::vector<std::filesystem::path> write_pictures(std::span<const Result> results,
                                                  const PictureOptions& options,
                                                  const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files{folder / "curves.png"};
  write_curve_picture(results, options, files.front());
  for (std::size_t n = 0; n < results.size(); ++n) {
    if (results[n].snapshots.empty() && options.colour.empty()) continue;
    files.push_back(folder / (results.size() > 1 ? fmt::format("packing_{}.png", n + 1) : "packing.png"));
    write_packing_picture(results[n], options, files.back());
  }
  return files;
}

}  // namespace frit::report
