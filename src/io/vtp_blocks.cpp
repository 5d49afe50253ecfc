#include "io/vtp_blocks.hpp"

#include <fmt/core.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cstring>
#include <vector>

#include "core/error.hpp"

namespace frit::io {

static_assert(std::endian::native == std::endian::little, "VTP files are written little endian");

namespace {

constexpr std::size_t block_bytes = std::size_t{1} << 17;
constexpr int compression_level = 3;  // positions hardly shrink at any level; higher ones only cost time

void append_size(std::string& data, std::uint64_t size) {
  char bytes[sizeof size];
  std::memcpy(bytes, &size, sizeof size);
  data.append(bytes, sizeof size);
}

std::uint64_t read_size(std::string_view data, std::uint64_t offset) {
  std::uint64_t size = 0;
  std::memcpy(&size, data.data() + offset, sizeof size);
  return size;
}

std::string compress_block(std::span<const std::byte> block) {
  uLongf size = compressBound(static_cast<uLong>(block.size()));
  std::string compressed(size, '\0');
  const int result = compress2(reinterpret_cast<Bytef*>(compressed.data()), &size,
                               reinterpret_cast<const Bytef*>(block.data()), static_cast<uLong>(block.size()),
                               compression_level);
  if (result != Z_OK)
    throw MachineError("compressing a VTP array failed: out of memory; close other programs");
  compressed.resize(size);
  return compressed;
}

bool uncompress_block(std::string_view compressed, std::span<std::byte> block) {
  auto size = static_cast<uLongf>(block.size());
  const int result =
      uncompress(reinterpret_cast<Bytef*>(block.data()), &size,
                 reinterpret_cast<const Bytef*>(compressed.data()), static_cast<uLong>(compressed.size()));
  return result == Z_OK && size == block.size();
}

}  // namespace

void append_compressed(std::string& data, std::span<const std::byte> array) {
  std::vector<std::string> blocks;
  for (std::size_t begin = 0; begin < array.size(); begin += block_bytes) {
    blocks.push_back(compress_block(array.subspan(begin, std::min(block_bytes, array.size() - begin))));
  }
  append_size(data, blocks.size());
  append_size(data, block_bytes);
  append_size(data, array.size() % block_bytes);
  for (const auto& block : blocks) append_size(data, block.size());
  for (const auto& block : blocks) data += block;
}

std::string read_compressed(std::string_view data, std::uint64_t offset, std::span<std::byte> array) {
  constexpr std::uint64_t size_bytes = sizeof(std::uint64_t), table_begin = 3 * size_bytes;
  if (offset > data.size() || data.size() - offset < table_begin)
    return "it begins behind the end of the file";
  data.remove_prefix(offset);
  const auto blocks = read_size(data, 0), full_block = read_size(data, size_bytes),
             partial = read_size(data, 2 * size_bytes);
  if (blocks > (data.size() - table_begin) / size_bytes) return "its blocks reach behind the end of the file";
  const auto last_block = partial > 0 ? partial : full_block;
  const bool sizes_fit = full_block > 0 && last_block <= full_block && full_block <= UINT32_MAX &&
                         (blocks == 0 ? 0 : (blocks - 1) * full_block + last_block) == array.size();
  if (!sizes_fit) return fmt::format("its blocks do not make the {} bytes that are needed", array.size());
  std::uint64_t begin = table_begin + blocks * size_bytes;
  for (std::uint64_t block = 0; block < blocks; ++block) {
    const auto compressed = read_size(data, table_begin + block * size_bytes);
    if (compressed > data.size() - begin) return "its blocks reach behind the end of the file";
    const auto length = block + 1 == blocks ? last_block : full_block;
    if (!uncompress_block(data.substr(begin, compressed), array.subspan(block * full_block, length))) {
      return fmt::format("its block {} is damaged", block);
    }
    begin += compressed;
  }
  return "";
}

bool could_hold(std::size_t file_bytes, std::uint64_t array_bytes) {
  return array_bytes / 1100 <= file_bytes;
}

}  // namespace frit::io
