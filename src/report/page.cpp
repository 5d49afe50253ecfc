#include "report/page.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "io/write_file.hpp"
#include "report/binary.hpp"
#include "report/case_words.hpp"
#include "report/colour_map.hpp"
#include "report/page_asset.hpp"
#include "run/machine.hpp"

namespace frit::report {
namespace {

using nlohmann::json;

json series_of(const io::Series& series) {
  json columns = json::array(), values = json::array();
  for (std::size_t n = 0; n < series.columns.size(); ++n) {
    columns.push_back(series.columns[n]);
    json numbers = json::array();
    for (const double value : series.values[n])
      numbers.push_back(std::isfinite(value) ? json(value) : json());
    values.push_back(std::move(numbers));
  }
  return {{"columns", columns}, {"values", values}};
}

// tau = tau_per_theta theta, with R the mean radius (docs/notation.md); null where R is not known.
json tau_per_theta(const Result& result, double mean_radius) {
  const double R = mean_radius > 0.0               ? mean_radius
                   : result.whole.packing.generate ? result.whole.packing.radius
                                                   : 0.0;
  return R > 0.0 ? json(result.whole.material.surface_energy / std::pow(R, 4)) : json();
}

std::size_t particle_count(const Result& result, const PackingData& packing) {
  if (!packing.description.is_null()) return packing.description["count"];
  return result.summary.value(
      "particles", static_cast<std::size_t>(std::max<std::int64_t>(0, result.whole.packing.count)));
}

struct RunInPage {
  json description;
  std::vector<std::string> frames;
};

RunInPage run_of(const Result& result, const PageLimits& limits) {
  PackingData packing = pack_snapshots(result, limits);
  json notes = packing.notes;
  if (result.summary.empty())
    notes.push_back("summary.json is missing: the run has not ended, or was cut short");
  json run{{"name", result.name},
           {"title", result.whole.title},
           {"words", case_in_words(result.whole, particle_count(result, packing))},
           {"material", material_of(result.whole)},
           {"summary", result.summary},
           {"notes", notes},
           {"series", series_of(result.series)},
           {"tau_per_theta", tau_per_theta(result, packing.mean_radius)},
           {"distributions", packing.distributions},
           {"packing", packing.description}};
  return {std::move(run), std::move(packing.frames)};
}

json maps_of() {
  json maps = json::array();
  for (const ColourMap& map : colour_maps()) {
    maps.push_back(
        {{"name", map.name}, {"colours", base64(std::span(map.table.front().data(), sizeof(map.table)))}});
  }
  return maps;
}

// JSON inside an HTML script element: "<" could end it.
std::string embedded(const json& value) {
  const std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  std::string safe;
  safe.reserve(text.size());
  for (const char letter : text) {
    if (letter == '<') {
      safe += "\\u003c";
    } else {
      safe += letter;
    }
  }
  return safe;
}

std::string escape_html(const std::string& text) {
  std::string safe;
  for (const char letter : text) {
    switch (letter) {
      case '&':
        safe += "&amp;";
        break;
      case '<':
        safe += "&lt;";
        break;
      case '>':
        safe += "&gt;";
        break;
      default:
        safe += letter;
    }
  }
  return safe;
}

}  // namespace

bool has_page() { return !page_script.empty(); }

std::string make_page(std::span<const Result> results, const PageLimits& limits) {
  PageLimits share = limits;
  share.bytes /= static_cast<double>(results.size());
  json runs = json::array();
  std::string frames;
  for (const Result& result : results) {
    RunInPage run = run_of(result, share);
    for (std::size_t n = 0; n < run.frames.size(); ++n) {
      frames += fmt::format("<script type=\"application/octet-stream\" id=\"frame-{}-{}\">{}</script>\n",
                            runs.size(), n, run.frames[n]);
    }
    runs.push_back(std::move(run.description));
  }
  const std::string& first = results.front().whole.title;
  const std::string title = first.empty() ? results.front().name : first;
  const json data{{"version", run::version()}, {"maps", maps_of()}, {"runs", runs}};
  return fmt::format(
      "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{} – frit</title>\n"
      "<style>{}</style>\n</head>\n<body>\n<noscript>This report draws its curves with JavaScript, which is "
      "off in this "
      "browser.</noscript>\n<script type=\"application/json\" "
      "id=\"data\">{}</script>\n{}<script>{}</script>\n</body>\n"
      "</html>\n",
      escape_html(title), page_style, embedded(data), frames, page_script);
}

std::vector<Result> read_results(std::span<const std::filesystem::path> folders) {
  std::vector<Result> results;
  std::vector<std::string> faults;
  for (const std::filesystem::path& folder : folders) {
    try {
      results.push_back(read_result(folder));
    } catch (const InputError& error) {
      faults.insert(faults.end(), error.faults().begin(), error.faults().end());
    }
  }
  if (!faults.empty()) throw InputError(faults);
  return results;
}

void write_page(std::span<const std::filesystem::path> folders, const std::filesystem::path& file) {
  if (!has_page()) throw MachineError(std::string(page_missing_text));
  io::write_file_whole(file, make_page(read_results(folders)));
}

}  // namespace frit::report
