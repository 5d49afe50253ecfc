#include "observe/sphere_box.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/constants.hpp"
#include "core/contract.hpp"

namespace frit::observe {
namespace {

struct GaussPoint {
  double abscissa, weight;
};
// Gauss-Legendre rule of 10 points on [-1, 1]; the points come in pairs of either sign.
constexpr std::array<GaussPoint, 5> gauss_rule{{{0.1488743389816312, 0.2955242247147529},
                                                {0.4333953941292472, 0.2692667193099963},
                                                {0.6794095682990244, 0.2190863625159820},
                                                {0.8650633666889845, 0.1494513491505806},
                                                {0.9739065285171717, 0.0666713443086881}}};

// Integral over [low, high] of a function that may behave like a power of a square root at both ends:
// with z = middle - half cos(angle) it is smooth in the angle.
template <class Function>
double integrate(double low, double high, Function&& value) {
  const double middle = 0.5 * (low + high), half = 0.5 * (high - low);
  double sum = 0.0;
  for (const GaussPoint& point : gauss_rule) {
    for (const double side : {-point.abscissa, point.abscissa}) {
      const double angle = 0.5 * pi * (1.0 + side);
      sum += point.weight * std::sin(angle) * value(middle - half * std::cos(angle));
    }
  }
  return 0.5 * pi * half * sum;
}

// Root of a difference that round-off or geometry may turn negative.
double root(double value) { return std::sqrt(std::max(value, 0.0)); }

// Area under the quarter circle between 0 and x <= radius.
double area_under_circle(double radius, double x) {
  return 0.5 * (x * root(radius * radius - x * x) + radius * radius * std::asin(std::min(x / radius, 1.0)));
}

// Area of the disc about the origin within [0, a] x [0, b].
double disc_in_quadrant(double radius, double a, double b) {
  if (a * a + b * b <= radius * radius) return a * b;
  a = std::min(a, radius);
  b = std::min(b, radius);
  const double flat = root(radius * radius - b * b);
  return b * flat + area_under_circle(radius, a) - area_under_circle(radius, flat);
}

// Volume of the unit ball about the origin within [0, a] x [0, b] x [0, c], 0 <= edges <= 1, ascending.
double ball_in_octant(std::array<double, 3> edge) {
  std::sort(edge.begin(), edge.end());
  const double c = edge[0], b = edge[1], a = edge[2];
  if (a * a + b * b + c * c <= 1.0) return a * b * c;
  if (b >= 1.0) return 0.25 * pi * (c - c * c * c / 3.0);
  // The slice at z changes its kind where its circle passes a corner or an edge of the rectangle.
  std::array<double, 5> ends{0.0, root(1.0 - a * a - b * b), root(1.0 - a * a), root(1.0 - b * b), c};
  double volume = 0.0;
  for (std::size_t part = 0; part + 1 < ends.size(); ++part) {
    const double low = std::min(ends[part], c), high = std::min(ends[part + 1], c);
    if (high <= low) continue;
    volume += integrate(low, high, [&](double z) { return disc_in_quadrant(root(1.0 - z * z), a, b); });
  }
  return volume;
}

// The same with edges of either sign, odd in each: differences of it give any box.
double signed_ball_in_octant(const Vec3& corner) {
  std::array<double, 3> edge;
  double sign = 1.0;
  for (int axis = 0; axis < 3; ++axis) {
    edge[axis] = std::min(std::abs(corner[axis]), 1.0);
    if (corner[axis] < 0.0) sign = -sign;
  }
  return sign * ball_in_octant(edge);
}

}  // namespace

double sphere_volume_in_box(const Vec3& centre, double radius, const Box& box) {
  FRIT_EXPECT(radius > 0.0 && (box.low.array() <= box.high.array()).all());
  const std::array<Vec3, 2> corners{(box.low - centre) / radius, (box.high - centre) / radius};
  const double cube = radius * radius * radius;
  if (corners[0].maxCoeff() >= 1.0 || corners[1].minCoeff() <= -1.0) return 0.0;
  if (corners[0].maxCoeff() <= -1.0 && corners[1].minCoeff() >= 1.0) return 4.0 / 3.0 * pi * cube;
  double volume = 0.0;
  for (int corner = 0; corner < 8; ++corner) {
    const int x = corner & 1, y = (corner >> 1) & 1, z = (corner >> 2) & 1;
    const double part = signed_ball_in_octant({corners[x].x(), corners[y].y(), corners[z].z()});
    volume += (x + y + z) % 2 == 1 ? part : -part;
  }
  return std::max(volume, 0.0) * cube;
}

}  // namespace frit::observe
