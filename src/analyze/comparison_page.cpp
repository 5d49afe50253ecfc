#include "analyze/comparison_page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>
#include <utility>

#include "analyze/line_plot.hpp"
#include "io/text.hpp"
#include "io/write_file.hpp"
#include "observe/statistics.hpp"
#include "run/folders.hpp"

namespace frit::analyze {
namespace {

constexpr const char* density = "relative_density";

// Figures of the tables, and what they are called there.
struct Told {
  const char* column;
  const char* name;
};
constexpr std::array<Told, 8> told_figures{
    {{"relative_density", "relative density"},
     {"time [s]", "time [s]"},
     {"tau", "dimensionless time theta gamma/R^4"},
     {"coordination", "coordination"},
     {"neck_ratio_mean", "neck ratio r/R, mean"},
     {"rearrangement_pair_ratio", "rearrangement (pair ratio)"},
     {"rearrangement_deviation_mean", "rearrangement (deviation / R), mean"},
     {"rotation_mean [rad]", "rotation of grains [rad], mean"}}};

const char* abscissa_name(const Comparison& comparison) {
  return comparison.equal == Equal::density ? density : "tau";
}

bool has_values(const Figure& figure) {
  return std::ranges::any_of(figure.values, [](const std::vector<double>& values) {
    return std::ranges::any_of(values, [](double value) { return !std::isnan(value); });
  });
}

// The figures to tell: all of `told_figures` that are known and are not the abscissa.
std::vector<std::pair<const Figure*, const char*>> chosen(const Comparison& comparison) {
  std::vector<std::pair<const Figure*, const char*>> found;
  for (const auto& [column, name] : told_figures) {
    if (std::string_view(column) == abscissa_name(comparison)) continue;
    const auto figure = std::ranges::find(comparison.figures, column, &Figure::column);
    if (figure != comparison.figures.end() && has_values(*figure)) found.emplace_back(&*figure, name);
  }
  return found;
}

std::string number_text(double value) { return std::isnan(value) ? "-" : fmt::format("{:.5g}", value); }

std::string value_text(const Figure& figure, std::size_t result, std::size_t point) {
  const std::string value = number_text(figure.values[result][point]);
  const double difference = percent(figure, result, point);
  return result == 0 || !std::isfinite(difference) ? value : fmt::format("{} ({:+.2f} %)", value, difference);
}

std::string range_text(const Comparison& comparison) {
  std::string text;
  for (std::size_t n = 0; n < comparison.names.size(); ++n) {
    const auto [low, high] = comparison.ranges[n];
    text += std::isnan(low) ? fmt::format("{}: has no {}\n", comparison.names[n], abscissa_name(comparison))
                            : fmt::format("{}: {} from {} to {}\n", comparison.names[n],
                                          abscissa_name(comparison), number_text(low), number_text(high));
  }
  return text;
}

std::string nothing_common(const Comparison& comparison) {
  return fmt::format("nothing to compare: the results have no common {}\n{}", abscissa_name(comparison),
                     range_text(comparison));
}

// Rows of cells; the first row holds the names.
using Cells = std::vector<std::vector<std::string>>;

Cells cells_of(const Comparison& comparison, const Figure& figure) {
  Cells cells{{abscissa_name(comparison)}};
  cells.front().insert(cells.front().end(), comparison.names.begin(), comparison.names.end());
  for (std::size_t point = 0; point < comparison.points.size(); ++point) {
    cells.push_back({number_text(comparison.points[point])});
    for (std::size_t n = 0; n < comparison.names.size(); ++n)
      cells.back().push_back(value_text(figure, n, point));
  }
  return cells;
}

Cells cells_of(const Comparison& comparison, const std::vector<CaseDifference>& differences) {
  Cells cells{{"key"}};
  cells.front().insert(cells.front().end(), comparison.names.begin(), comparison.names.end());
  for (const CaseDifference& difference : differences) {
    cells.push_back({difference.key});
    for (const std::string& value : difference.values) cells.back().push_back(value.empty() ? "-" : value);
  }
  return cells;
}

std::string aligned(const Cells& cells) {
  std::vector<std::size_t> widths(cells.front().size(), 0);
  for (const auto& row : cells)
    for (std::size_t n = 0; n < row.size(); ++n) widths[n] = std::max(widths[n], row[n].size());
  std::string text;
  for (const auto& row : cells) {
    text += fmt::format("  {:<{}}", row[0], widths[0]);
    for (std::size_t n = 1; n < row.size(); ++n) text += fmt::format("  {:>{}}", row[n], widths[n]);
    text += "\n";
  }
  return text;
}

std::string markdown(const Cells& cells) {
  std::string text;
  for (std::size_t row = 0; row < cells.size(); ++row) {
    for (const std::string& cell : cells[row]) text += "| " + cell + " ";
    text += "|\n";
    if (row > 0) continue;
    for (std::size_t n = 0; n < cells[row].size(); ++n) text += n == 0 ? "|---" : "|---:";
    text += "|\n";
  }
  return text + "\n";
}

void append_csv_row(std::string& text, const Comparison& comparison, const Figure& figure,
                    std::size_t point) {
  text += figure.column + ",";
  io::append_number(text, comparison.points[point]);
  for (std::size_t n = 0; n < comparison.names.size(); ++n) {
    text += ",";
    if (!std::isnan(figure.values[n][point])) io::append_number(text, figure.values[n][point]);
    if (n == 0) continue;
    text += ",";
    const double difference = percent(figure, n, point);
    if (std::isfinite(difference)) io::append_number(text, difference);
  }
  text += "\n";
}

std::string csv_of(const Comparison& comparison) {
  std::string text = fmt::format("figure,{}", abscissa_name(comparison));
  for (std::size_t n = 0; n < comparison.names.size(); ++n) {
    text += fmt::format(",\"{}\"", comparison.names[n]);
    if (n > 0) text += fmt::format(",\"{}: difference [%]\"", comparison.names[n]);
  }
  text += "\n";
  for (const Figure& figure : comparison.figures)
    for (std::size_t point = 0; point < comparison.points.size(); ++point)
      append_csv_row(text, comparison, figure, point);
  return text;
}

struct PlotFile {
  std::string name;
  LinePlot plot;
};

std::vector<double> column_or_tau(const Result& result, const std::string& name) {
  if (name == "tau") return tau_of(result);
  const std::vector<double>* column = result.column(name);
  return column != nullptr ? *column
                           : std::vector<double>(result.series.values.front().size(), observe::no_value);
}

// Whole series, not only the points of the comparison.
LinePlot plot_of(const std::vector<Result>& results, const std::string& x, const std::string& y) {
  LinePlot plot;
  for (const Result& result : results)
    plot.lines.push_back({result.name, column_or_tau(result, x), column_or_tau(result, y)});
  return plot;
}

std::vector<PlotFile> plots_of(const std::vector<Result>& results) {
  const bool scaled =
      std::ranges::none_of(results, [](const Result& r) { return std::isnan(r.tau_per_theta); });
  std::vector<PlotFile> plots;
  LinePlot first = plot_of(results, scaled ? "tau" : "time [s]", density);
  first.x_label = scaled ? "dimensionless time theta gamma/R^4" : "time [s]";
  first.y_label = "relative density";
  first.x_scale = Scale::logarithmic;
  plots.push_back({"density", std::move(first)});
  constexpr std::array<Told, 3> against_density{{{"rearrangement_pair_ratio", "rearrangement"},
                                                 {"neck_ratio_mean", "necks"},
                                                 {"coordination", "coordination"}}};
  for (const auto& [column, name] : against_density) {
    LinePlot plot = plot_of(results, density, column);
    const auto told = std::ranges::find(told_figures, std::string_view(column), &Told::column);
    plot.x_label = "relative density";
    plot.y_label = told->name;
    plots.push_back({name, std::move(plot)});
  }
  return plots;
}

std::string page_of(const Comparison& comparison, const std::vector<PlotFile>& plots) {
  std::string page = "# Comparison of results\n\n";
  page += comparison.differences.empty()
              ? "The cases do not differ.\n\n"
              : "Keys that differ:\n\n" + markdown(cells_of(comparison, comparison.differences));
  for (const PlotFile& file : plots)
    page += fmt::format("![{} against {}]({}.svg)\n\n", file.plot.y_label, file.plot.x_label, file.name);
  if (comparison.points.empty()) return page + nothing_common(comparison);
  page += fmt::format(
      "Figures at equal {}, interpolated between the rows of each series.csv; in brackets the difference to "
      "{}. "
      "All "
      "columns are in compare.csv.\n\n",
      abscissa_name(comparison), comparison.names.front());
  for (const auto& [figure, name] : chosen(comparison))
    page += fmt::format("## {}\n\n{}", name, markdown(cells_of(comparison, *figure)));
  return page;
}

}  // namespace

std::string to_text(const Comparison& comparison) {
  std::string text = comparison.differences.empty()
                         ? "the cases do not differ\n"
                         : "keys that differ\n" + aligned(cells_of(comparison, comparison.differences));
  if (comparison.points.empty()) return text + nothing_common(comparison);
  for (const auto& [figure, name] : chosen(comparison))
    text += fmt::format("{}\n{}", name, aligned(cells_of(comparison, *figure)));
  return text;
}

void write_comparison(const std::filesystem::path& folder, const Comparison& comparison,
                      const std::vector<Result>& results) {
  run::make_folder(folder);
  const std::vector<PlotFile> plots = plots_of(results);
  for (const PlotFile& file : plots) io::write_file_whole(folder / (file.name + ".svg"), draw(file.plot));
  io::write_file_whole(folder / "compare.csv", csv_of(comparison));
  io::write_file_whole(folder / "compare.md", page_of(comparison, plots));
}

}  // namespace frit::analyze
