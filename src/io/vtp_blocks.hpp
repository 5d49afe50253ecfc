// The binary part of a VTP file: arrays cut into blocks, each compressed by zlib, behind a table of 64-bit
// sizes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace frit::io {

// Appends an array to `data`: number of blocks, bytes a block, bytes of a partial last block (0: it is full),
// compressed bytes of each block, then the blocks. Little endian, 64 bits each.
void append_compressed(std::string& data, std::span<const std::byte> array);

// Fills `array` from the compressed array at data[offset]. Nothing is allocated by sizes the file claims.
// Returns what is wrong, or nothing if all went well.
std::string read_compressed(std::string_view data, std::uint64_t offset, std::span<std::byte> array);

// zlib makes at most about 1030 bytes of one: more than this from a file of file_bytes cannot be true.
bool could_hold(std::size_t file_bytes, std::uint64_t array_bytes);

}  // namespace frit::io
