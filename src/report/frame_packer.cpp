#include "report/frame_packer.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/result.hpp"

namespace frit::report {
namespace {

// A place in [0, 1) of a periodic cell, or in [0, 1] of a box, in steps that 16 bits hold.
std::uint16_t place_code(double place, bool periodic) {
  if (periodic)
    return static_cast<std::uint16_t>(std::llround((place - std::floor(place)) * 65536.0) & 0xffff);
  return static_cast<std::uint16_t>(std::lround(std::clamp(place, 0.0, 1.0) * 65535.0));
}

std::vector<std::uint16_t> place_codes(const io::Frame& frame, const FramePacker::Box& box, int axis) {
  std::vector<std::uint16_t> codes;
  codes.reserve(frame.size());
  for (const Vec3& position : frame.positions) {
    codes.push_back(place_code((position[axis] - box.origin[axis]) / box.size[axis], frame.cell.periodic));
  }
  return codes;
}

}  // namespace

std::uint8_t FieldScale::code_of(double value) const {
  if (!std::isfinite(value)) return 255;
  if (!(most > least)) return 0;
  const double part = std::clamp((value - least) / (most - least), 0.0, 1.0);
  return static_cast<std::uint8_t>(std::lround(254.0 * (is_square ? std::sqrt(part) : part)));
}

FramePacker::Box FramePacker::box_of(const io::Frame& frame) {
  if (frame.cell.periodic) return {frame.origin, frame.cell.size};
  Vec3 low = frame.positions.front(), high = low;
  for (const Vec3& position : frame.positions) {
    low = low.cwiseMin(position);
    high = high.cwiseMax(position);
  }
  // A flat body still has a box with a volume.
  const double least = 1e-3 * *std::ranges::max_element(frame.radii);
  return {low, (high - low).cwiseMax(least)};
}

Bytes FramePacker::pack(const io::Frame& frame, const NeckData* necks) {
  Bytes bytes;
  const Box box = box_of(frame);
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<std::uint16_t> places = place_codes(frame, box, axis);
    std::vector<std::uint16_t>& last = last_places_[static_cast<std::size_t>(axis)];
    last.resize(places.size(), 0);
    std::vector<std::uint16_t> change(places.size());
    for (std::size_t n = 0; n < places.size(); ++n)
      change[n] = static_cast<std::uint16_t>(places[n] - last[n]);
    append_planes(bytes, change);
    last = std::move(places);
  }
  std::vector<std::uint16_t> radii;
  for (const double radius : frame.radii) {
    radii.push_back(
        static_cast<std::uint16_t>(std::lround(65535.0 * std::min(1.0, radius / largest_radius_))));
  }
  append_planes(bytes, radii);
  for (const FieldScale& field : fields_) {
    const auto values = scalars(frame.arrays, field.name);
    for (std::size_t n = 0; n < frame.size(); ++n)
      bytes.push_back(values ? field.code_of((*values)[n]) : 255);
  }
  if (necks == nullptr) return bytes;
  std::uint32_t last_i = 0;
  for (std::size_t k = 0; k < necks->i.size(); ++k) {
    append_varint(bytes, necks->i[k] - last_i);
    append_varint(bytes, zigzag(static_cast<std::int64_t>(necks->j[k]) - necks->i[k]));
    last_i = necks->i[k];
  }
  for (const double ratio : necks->ratio) {
    bytes.push_back(static_cast<std::uint8_t>(std::lround(254.0 * std::clamp(ratio, 0.0, 1.0))));
  }
  return bytes;
}

NeckData necks_of(const io::PolyData& network, const std::vector<std::int64_t>& ids) {
  const auto i = scalars(network.cell_arrays, "i"), j = scalars(network.cell_arrays, "j");
  const auto ratio = scalars(network.cell_arrays, "neck_ratio");
  NeckData necks;
  if (!i || !j || !ratio) return necks;
  const auto row_of = [&](double id) {
    const auto found = std::ranges::lower_bound(ids, static_cast<std::int64_t>(id));
    const bool known = found != ids.end() && *found == static_cast<std::int64_t>(id);
    return known ? static_cast<std::size_t>(found - ids.begin()) : ids.size();
  };
  std::vector<std::array<std::size_t, 3>> rows;  // row of i, row of j, place in the network
  for (std::size_t k = 0; k < i->size(); ++k) {
    const std::size_t first = row_of((*i)[k]), second = row_of((*j)[k]);
    if (first == second || first == ids.size() || second == ids.size()) continue;
    rows.push_back({std::min(first, second), std::max(first, second), k});
  }
  std::ranges::sort(rows);
  for (const auto& [first, second, k] : rows) {
    necks.i.push_back(static_cast<std::uint32_t>(first));
    necks.j.push_back(static_cast<std::uint32_t>(second));
    necks.ratio.push_back((*ratio)[k]);
  }
  return necks;
}

}  // namespace frit::report
