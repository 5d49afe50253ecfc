// Lines, text and pictures on a page of pixels, written as PNG. The only header that stands for cairo.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "report/sphere_picture.hpp"

namespace frit::report {

struct Point {
  double x, y;  // [pixels] from the top left
};

enum class Align { left, centre, right };

struct Pen {
  Rgb colour{40, 42, 46};
  double width = 1.0;    // [pixels]
  double opacity = 1.0;  // of what is filled
};

struct TextStyle {
  double size;  // [pixels]
  Align align = Align::left;
  Rgb colour{40, 42, 46};
  bool bold = false;
  bool upwards = false;  // turned by a quarter
};

class Canvas {
 public:
  Canvas(int width, int height);  // white
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  void line(const std::vector<Point>& points, const Pen& pen);
  void area(const std::vector<Point>& points, const Pen& pen);
  void disc(Point middle, double radius, const Pen& pen);
  // The text's baseline is at `at`.
  void text(const std::string& text, Point at, const TextStyle& style);
  double text_width(const std::string& text, const TextStyle& style);
  void image(const Image& image, Point top_left);
  // What is drawn until the next call shows within the box only; no box: everywhere.
  void clip(Point top_left, Point bottom_right);
  void clip_nothing();

  // Whole or not at all; MachineError if it cannot be written.
  void write_png(const std::filesystem::path& path);

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace frit::report
