// Turns frames into the bytes of a page; each frame builds on the one before.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "io/vtp.hpp"
#include "report/binary.hpp"

namespace frit::report {

// A quantity in 255 codes: v = most (code/254)^2, or (least, most) linearly where there are negative values
// or whole numbers; code 255: no value.
struct FieldScale {
  std::string name;  // with its unit
  double least = 0.0, most = 0.0;
  bool is_square = false;

  std::uint8_t code_of(double value) const;
};

struct NeckData {
  std::vector<std::uint32_t> i, j;  // rows of the frame
  std::vector<double> ratio;        // r/R
};

class FramePacker {
 public:
  // `largest_radius` [m], of all frames.
  FramePacker(std::vector<FieldScale> fields, double largest_radius)
      : fields_(std::move(fields)), largest_radius_(largest_radius) {}

  // x, y, z as difference to the frame before (of the first: to 0), each as planes; radii as planes; codes of
  // each field; with necks: varints of i - i before and zigzag(j - i), then a byte of 254 times the ratio
  // each.
  Bytes pack(const io::Frame& frame, const NeckData* necks);

  // The box of a frame: the cell, or what holds all centres of a free body [m].
  struct Box {
    Vec3 origin, size;
  };
  static Box box_of(const io::Frame& frame);

 private:
  std::vector<FieldScale> fields_;
  double largest_radius_;
  std::array<std::vector<std::uint16_t>, 3> last_places_;
};

// The necks of a network between particles with these ids (ascending), sorted by i; those of unknown
// particles, or of a particle with its own copy, are left out. Empty where the network tells no neck ratio.
NeckData necks_of(const io::PolyData& network, const std::vector<std::int64_t>& ids);

}  // namespace frit::report
