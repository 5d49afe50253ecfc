// Particles and necks over time, as compact as a page needs them: places to a 65,535th of the box, quantities
// to 1/254 of the root of their range.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "report/result.hpp"

namespace frit::report {

// What a page may hold of one run.
struct PageLimits {
  double bytes = 4e6;               // about, after packing
  std::size_t most_frames = 60;     // in the 3D view
  std::size_t most_necks = 150000;  // a frame; more are left out
};

struct PackingData {
  nlohmann::json description;       // docs/report.md, "What is in the page"; null without snapshots
  nlohmann::json distributions;     // [{...}], one entry a quantity
  std::vector<std::string> frames;  // base64 of a zlib stream each
  std::vector<std::string> notes;   // what was left out, for the reader
  double mean_radius = 0.0;         // [m]; 0: not known
};

// Places 0 .. count - 1, evenly chosen, the first and the last among them; all where `wanted` is not below
// `count`.
std::vector<std::size_t> choose_evenly(std::size_t count, std::size_t wanted);

// InputError where a snapshot is damaged or holds other particles than the first.
PackingData pack_snapshots(const Result& result, const PageLimits& limits);

}  // namespace frit::report
