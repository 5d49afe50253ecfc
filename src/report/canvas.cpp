#include "report/canvas.hpp"

#include <cairo.h>

#include <cstdint>
#include <cstring>
#include <numbers>

#include "core/error.hpp"
#include "io/write_file.hpp"

namespace frit::report {

struct Canvas::Parts {
  cairo_surface_t* surface;
  cairo_t* context;
};

namespace {

void set_colour(cairo_t* context, const Rgb& colour, double opacity = 1.0) {
  cairo_set_source_rgba(context, colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0, opacity);
}

void trace_path(cairo_t* context, const std::vector<Point>& points) {
  cairo_new_path(context);
  for (const Point& point : points) cairo_line_to(context, point.x, point.y);
}

void set_font(cairo_t* context, const TextStyle& style) {
  cairo_select_font_face(context, "sans-serif", CAIRO_FONT_SLANT_NORMAL,
                         style.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(context, style.size);
}

cairo_status_t append_bytes(void* text, const unsigned char* bytes, unsigned int length) {
  static_cast<std::string*>(text)->append(reinterpret_cast<const char*>(bytes), length);
  return CAIRO_STATUS_SUCCESS;
}

void check(cairo_status_t status) {
  if (status == CAIRO_STATUS_SUCCESS) return;
  throw MachineError(std::string("drawing a picture failed: ") + cairo_status_to_string(status) +
                     "; try a smaller --width");
}

}  // namespace

Canvas::Canvas(int width, int height) : parts_(std::make_unique<Parts>()) {
  parts_->surface = cairo_image_surface_create(CAIRO_FORMAT_RGB24, width, height);
  parts_->context = cairo_create(parts_->surface);
  cairo_set_source_rgb(parts_->context, 1.0, 1.0, 1.0);
  cairo_paint(parts_->context);
  cairo_set_line_join(parts_->context, CAIRO_LINE_JOIN_ROUND);
}

Canvas::~Canvas() {
  cairo_destroy(parts_->context);
  cairo_surface_destroy(parts_->surface);
}

void Canvas::line(const std::vector<Point>& points, const Pen& pen) {
  trace_path(parts_->context, points);
  set_colour(parts_->context, pen.colour);
  cairo_set_line_width(parts_->context, pen.width);
  cairo_stroke(parts_->context);
}

void Canvas::area(const std::vector<Point>& points, const Pen& pen) {
  trace_path(parts_->context, points);
  cairo_close_path(parts_->context);
  set_colour(parts_->context, pen.colour, pen.opacity);
  cairo_fill(parts_->context);
}

void Canvas::disc(Point middle, double radius, const Pen& pen) {
  cairo_new_path(parts_->context);
  cairo_arc(parts_->context, middle.x, middle.y, radius, 0.0, 2.0 * std::numbers::pi);
  set_colour(parts_->context, pen.colour, pen.opacity);
  cairo_fill(parts_->context);
}

double Canvas::text_width(const std::string& text, const TextStyle& style) {
  set_font(parts_->context, style);
  cairo_text_extents_t extents;
  cairo_text_extents(parts_->context, text.c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(const std::string& text, Point at, const TextStyle& style) {
  const double share = style.align == Align::left ? 0.0 : style.align == Align::centre ? 0.5 : 1.0;
  const double shift = share * text_width(text, style);
  cairo_save(parts_->context);
  cairo_translate(parts_->context, at.x, at.y);
  if (style.upwards) cairo_rotate(parts_->context, -0.5 * std::numbers::pi);
  cairo_move_to(parts_->context, -shift, 0.0);
  set_colour(parts_->context, style.colour);
  cairo_show_text(parts_->context, text.c_str());
  cairo_restore(parts_->context);
}

void Canvas::image(const Image& image, Point top_left) {
  cairo_surface_t* picture = cairo_image_surface_create(CAIRO_FORMAT_RGB24, image.width, image.height);
  check(cairo_surface_status(picture));
  unsigned char* bytes = cairo_image_surface_get_data(picture);
  const int stride = cairo_image_surface_get_stride(picture);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) {
      const Rgb& pixel = image.pixels[static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                                      static_cast<std::size_t>(column)];
      const std::uint32_t word =
          static_cast<std::uint32_t>(pixel[0]) << 16 | static_cast<std::uint32_t>(pixel[1]) << 8 | pixel[2];
      std::memcpy(bytes + static_cast<std::ptrdiff_t>(row) * stride + std::ptrdiff_t{4} * column, &word,
                  sizeof word);
    }
  }
  cairo_surface_mark_dirty(picture);
  cairo_set_source_surface(parts_->context, picture, top_left.x, top_left.y);
  cairo_paint(parts_->context);
  cairo_surface_destroy(picture);
}

void Canvas::clip(Point top_left, Point bottom_right) {
  cairo_rectangle(parts_->context, top_left.x, top_left.y, bottom_right.x - top_left.x,
                  bottom_right.y - top_left.y);
  cairo_clip(parts_->context);
}

void Canvas::clip_nothing() { cairo_reset_clip(parts_->context); }

void Canvas::write_png(const std::filesystem::path& path) {
  check(cairo_status(parts_->context));
  std::string bytes;
  check(cairo_surface_write_to_png_stream(parts_->surface, append_bytes, &bytes));
  io::write_file_whole(path, bytes);
}

}  // namespace frit::report
