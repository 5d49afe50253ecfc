// Bytes for a page: small whole numbers in few bytes, deflated, as text that HTML can hold.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace frit::report {

using Bytes = std::vector<std::uint8_t>;

// LEB128: seven bits a byte, the lowest first, the top bit set where more follow.
void append_varint(Bytes& bytes, std::uint64_t value);

// 0, -1, 1, -2, ... as 0, 1, 2, 3, ..., so that small differences of either sign are short.
std::uint64_t zigzag(std::int64_t value);

// A 16 bit number each: all low bytes, then all high bytes, which deflate better apart.
void append_planes(Bytes& bytes, std::span<const std::uint16_t> values);

// A zlib stream, as browsers' DecompressionStream("deflate") reads it. MachineError if zlib fails.
Bytes deflate(std::span<const std::uint8_t> bytes);

// RFC 4648, padded.
std::string base64(std::span<const std::uint8_t> bytes);

}  // namespace frit::report
