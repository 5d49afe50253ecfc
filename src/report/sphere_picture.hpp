// Draws spheres exactly, by rays: no graphics card, no display, the same bytes for any number of threads.
#pragma once

#include <span>
#include <vector>

#include "core/vec.hpp"
#include "report/colour_map.hpp"

namespace frit::report {

// A sphere as the eye sees it: x to the right, y up, z away from the eye, any unit of length.
struct Ball {
  Vec3 centre;
  double radius;
  Rgb colour;
};

struct Image {
  int width = 0, height = 0;  // [pixels]
  std::vector<Rgb> pixels;    // row by row from the top left
};

struct PictureFrame {
  int width, height;         // [pixels]
  double half_height;        // of the window about the origin, in the unit of the balls
  double nearest, farthest;  // z of the front and back, for the haze of distance
};

// Parallel projection on white; 4 x 4 rays a pixel, averaged.
Image draw_balls(std::span<const Ball> balls, const PictureFrame& frame);

}  // namespace frit::report
