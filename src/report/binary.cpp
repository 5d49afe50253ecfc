#include "report/binary.hpp"

#include <zlib.h>

#include <string_view>

#include "core/error.hpp"

namespace frit::report {

void append_varint(Bytes& bytes, std::uint64_t value) {
  for (; value >= 0x80; value >>= 7) bytes.push_back(static_cast<std::uint8_t>(value | 0x80));
  bytes.push_back(static_cast<std::uint8_t>(value));
}

std::uint64_t zigzag(std::int64_t value) {
  const auto bits = static_cast<std::uint64_t>(value);
  return value < 0 ? ~(bits << 1) : bits << 1;
}

void append_planes(Bytes& bytes, std::span<const std::uint16_t> values) {
  for (const std::uint16_t value : values) bytes.push_back(static_cast<std::uint8_t>(value & 0xff));
  for (const std::uint16_t value : values) bytes.push_back(static_cast<std::uint8_t>(value >> 8));
}

Bytes deflate(std::span<const std::uint8_t> bytes) {
  uLongf size = compressBound(static_cast<uLong>(bytes.size()));
  Bytes packed(size);
  const auto length = static_cast<uLong>(bytes.size());
  if (compress2(packed.data(), &size, bytes.data(), length, Z_DEFAULT_COMPRESSION) != Z_OK) {
    throw MachineError("compressing the data of a report failed; there may be too little memory");
  }
  packed.resize(size);
  return packed;
}

std::string base64(std::span<const std::uint8_t> bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t n = 0; n < bytes.size(); n += 3) {
    const std::size_t left = bytes.size() - n;
    const unsigned group =
        bytes[n] << 16 | (left > 1 ? bytes[n + 1] << 8 : 0) | (left > 2 ? bytes[n + 2] : 0);
    text += digits[group >> 18];
    text += digits[group >> 12 & 63];
    text += left > 1 ? digits[group >> 6 & 63] : '=';
    text += left > 2 ? digits[group & 63] : '=';
  }
  return text;
}

}  // namespace frit::report
