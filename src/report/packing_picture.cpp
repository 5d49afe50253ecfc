#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "report/case_words.hpp"
#include "report/frame_packer.hpp"
#include "report/pictures.hpp"
#include "report/plot.hpp"
#include "report/sphere_picture.hpp"

namespace frit::report {
namespace {

constexpr Rgb no_value{150, 150, 150};

// What the colours mean.
struct Colouring {
  std::string label;
  std::vector<double> values;  // one a particle
  double least, most;          // of the colour bar

  Rgb colour_of(double value) const {
    if (!std::isfinite(value)) return no_value;
    const double part = most > least ? std::clamp((value - least) / (most - least), 0.0, 1.0) : 0.5;
    return colour_maps().front().table[static_cast<std::size_t>(std::lround(255.0 * part))];
  }
};

std::string names_of(const io::Frame& frame) {
  std::string names;
  for (const io::NamedArray& array : frame.arrays)
    names += (names.empty() ? "" : ", ") + split_unit(array.name).name;
  return names;
}

// The array asked for; without a wish the first of these that is there.
std::string chosen_array(const io::Frame& frame, const std::string& wish, const std::filesystem::path& file) {
  std::vector<std::string> wishes{wish};
  if (wish.empty()) wishes = {"rearrangement_d2min", "coordination"};
  for (const std::string& name : wishes) {
    const auto found = std::ranges::find_if(frame.arrays, [&](const io::NamedArray& array) {
      return array.name == name || split_unit(array.name).name == name;
    });
    if (found != frame.arrays.end()) return found->name;
  }
  throw InputError(
      fmt::format("--colour {}: {} has no such array; it has {}", wish, file.string(), names_of(frame)));
}

Colouring colouring_of(const io::Frame& frame, const std::string& name) {
  Colouring colouring{name, *scalars(frame.arrays, name), 0.0, 1.0};
  std::ranges::replace(colouring.label, '_', ' ');
  std::vector<double> sorted;
  std::ranges::copy_if(colouring.values, std::back_inserter(sorted),
                       [](double value) { return std::isfinite(value); });
  std::ranges::sort(sorted);
  if (sorted.empty()) return colouring;
  // A few extremes shall not leave one colour to all others.
  const auto last = static_cast<double>(sorted.size() - 1);
  colouring.least = sorted[static_cast<std::size_t>(0.01 * last)];
  colouring.most = sorted[static_cast<std::size_t>(std::ceil(0.99 * last))];
  return colouring;
}

// Rows: right, up, away from the eye; the view that the page starts with (web/src/camera.ts).
Eigen::Matrix3d view() {
  const double a = -0.55, b = 0.42;
  Eigen::Matrix3d flat, tilt;
  flat << std::cos(a), std::sin(a), 0.0, 0.0, 0.0, 1.0, -std::sin(a), std::cos(a), 0.0;
  tilt << 1.0, 0.0, 0.0, 0.0, std::cos(b), std::sin(b), 0.0, -std::sin(b), std::cos(b);
  return tilt * flat;
}

Vec3 wrapped(const Vec3& position, const FramePacker::Box& box, bool periodic) {
  Vec3 place = position - box.origin;
  if (periodic) place = place.array() - box.size.array() * (place.array() / box.size.array()).floor();
  return place - 0.5 * box.size;
}

// The edges of the cell as rows of small balls: they hide and are hidden like everything else.
void add_edges(const Vec3& size, double thickness, const Eigen::Matrix3d& turn, std::vector<Ball>& balls) {
  for (int axis = 0; axis < 3; ++axis) {
    const auto count = static_cast<int>(std::ceil(size[axis] / thickness));
    for (int corner = 0; corner < 4; ++corner) {
      Vec3 end = -0.5 * size;
      if ((corner & 1) != 0) end[(axis + 1) % 3] *= -1.0;
      if ((corner & 2) != 0) end[(axis + 2) % 3] *= -1.0;
      for (int n = 0; n <= count; ++n) {
        Vec3 place = end;
        place[axis] += size[axis] * n / count;
        balls.push_back({turn * place, thickness, {110, 110, 110}});
      }
    }
  }
}

// What is drawn, and how far it reaches from the middle [m].
struct Scene {
  std::vector<Ball> balls;
  double across = 0.0, up = 0.0, away = 0.0;
};

Scene scene_of(const io::Frame& frame, const Colouring& colouring) {
  const FramePacker::Box box = FramePacker::box_of(frame);
  const Eigen::Matrix3d turn = view();
  Scene scene;
  scene.balls.reserve(frame.size());
  for (std::size_t n = 0; n < frame.size(); ++n) {
    const Vec3 centre = turn * wrapped(frame.positions[n], box, frame.cell.periodic);
    scene.balls.push_back({centre, frame.radii[n], colouring.colour_of(colouring.values[n])});
    scene.across = std::max(scene.across, std::abs(centre.x()) + frame.radii[n]);
    scene.up = std::max(scene.up, std::abs(centre.y()) + frame.radii[n]);
    scene.away = std::max(scene.away, std::abs(centre.z()) + frame.radii[n]);
  }
  const double thickness = std::min(0.05 * mean_radius(frame), 0.002 * box.size.norm());
  if (frame.cell.periodic) add_edges(box.size, thickness, turn, scene.balls);
  return scene;
}

double round_length(double wanted) {
  const double power = std::pow(10.0, std::floor(std::log10(wanted)));
  return (wanted >= 5.0 * power ? 5.0 : wanted >= 2.0 * power ? 2.0 : 1.0) * power;
}

void draw_colour_bar(Canvas& canvas, const Colouring& colouring, const Box& box, double unit) {
  const ColourTable& table = colour_maps().front().table;
  const double left = box.top_left.x, width = box.bottom_right.x - left;
  for (std::size_t n = 0; n < table.size(); ++n) {
    const double from = left + width * static_cast<double>(n) / 256.0,
                 to = left + width * static_cast<double>(n + 1) / 256.0;
    // A little over the next one, which covers it: no seams.
    const double over = n + 1 < table.size() ? 1.0 : 0.0;
    canvas.area({{from, box.top_left.y},
                 {to + over, box.top_left.y},
                 {to + over, box.bottom_right.y},
                 {from, box.bottom_right.y}},
                {table[n], 0.0, 1.0});
  }
  for (const double tick : ticks(colouring.least, colouring.most, 5.0, AxisKind::linear)) {
    const double x = left + width * (tick - colouring.least) / (colouring.most - colouring.least);
    canvas.line({{x, box.bottom_right.y}, {x, box.bottom_right.y + 0.4 * unit}},
                {{93, 99, 107}, 0.1 * unit, 1.0});
    canvas.text(tick_text(tick), {x, box.bottom_right.y + 1.6 * unit},
                {.size = unit, .align = Align::centre});
  }
  canvas.text(colouring.label, {left + 0.5 * width, box.top_left.y - 0.6 * unit},
              {.size = unit, .align = Align::centre});
}

void draw_scale_bar(Canvas& canvas, Point left, double metres_per_pixel, double unit) {
  const double length = round_length(metres_per_pixel * 20.0 * unit), pixels = length / metres_per_pixel;
  canvas.line({{left.x, left.y - 0.4 * unit},
               left,
               {left.x + pixels, left.y},
               {left.x + pixels, left.y - 0.4 * unit}},
              {{40, 42, 46}, 0.16 * unit, 1.0});
  canvas.text(short_length(length), {left.x + 0.5 * pixels, left.y + 1.4 * unit},
              {.size = unit, .align = Align::centre});
}

std::string caption(const Result& result, const io::Frame& frame) {
  std::string text = fmt::format("t = {}", short_time(frame.time));
  const auto times = *column(result.series, "time");
  const auto densities = column(result.series, "relative_density");
  const auto row = std::ranges::find(times, frame.time);
  if (densities && row != times.end()) {
    const double density = (*densities)[static_cast<std::size_t>(row - times.begin())];
    if (std::isfinite(density)) text += fmt::format(", relative density {:.4g}", density);
  }
  return text + fmt::format(", {} particles", frame.size());
}

}  // namespace

void write_packing_picture(const Result& result, const PictureOptions& options,
                           const std::filesystem::path& file) {
  if (result.snapshots.empty()) {
    throw InputError(result.folder.string() +
                     ": no snapshots to draw; the run needs output.snapshots = true");
  }
  const std::filesystem::path& source = result.snapshots.back().particles;
  const io::Frame frame = io::read_vtp_frame(source);
  const Colouring colouring = colouring_of(frame, chosen_array(frame, options.colour, source));
  const Scene scene = scene_of(frame, colouring);

  const int width = options.width, height = width * 4 / 5;
  const double unit = width / 80.0;  // of text [pixels]
  const double head = 6.0 * unit, foot = 7.0 * unit;
  const int picture_height = static_cast<int>(height - head - foot);
  const double half_height = 1.03 * std::max(scene.up, scene.across * picture_height / width);
  Canvas canvas(width, height);
  canvas.image(draw_balls(scene.balls, {width, picture_height, half_height, -scene.away, scene.away}),
               {0.0, head});
  const std::string& title = result.whole.title.empty() ? result.name : result.whole.title;
  canvas.text(title, {2.0 * unit, 2.6 * unit}, {.size = 1.4 * unit, .bold = true});
  canvas.text(caption(result, frame), {2.0 * unit, 4.6 * unit},
              {.size = 1.1 * unit, .colour = {93, 99, 107}});
  draw_scale_bar(canvas, {2.0 * unit, height - 2.8 * unit}, 2.0 * half_height / picture_height, unit);
  const Box bar{{width - 34.0 * unit, height - 4.2 * unit}, {width - 3.0 * unit, height - 2.8 * unit}};
  draw_colour_bar(canvas, colouring, bar, unit);
  canvas.write_png(file);
}

}  // namespace frit::report
