// Pictures without a display: the packing as it ends, and curves.
#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "report/result.hpp"

namespace frit::report {

struct PictureOptions {
  int width = 2400;    // [pixels]
  std::string colour;  // a particle array of the snapshots, with or without its unit; empty:
                       // rearrangement_d2min or coordination
};

// Draws the last snapshot with the spheres to scale, coloured by a quantity, with colour bar and scale bar.
// InputError where there is no snapshot or no such quantity.
void write_packing_picture(const Result& result, const PictureOptions& options,
                           const std::filesystem::path& file);

// Draws density, rate, necks and rearrangement of all runs.
void write_curve_picture(std::span<const Result> results, const PictureOptions& options,
                         const std::filesystem::path& file);

// Writes both kinds beside each other: curves.png, and packing.png (several runs: packing_1.png, ...) for the
// runs with snapshots. Returns the files.
std::vector<std::filesystem::path> write_pictures(std::span<const Result> results,
                                                  const PictureOptions& options,
                                                  const std::filesystem::path& folder);

}  // namespace frit::report
