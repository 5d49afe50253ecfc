#include "io/sealed.hpp"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstring>

#include "core/contract.hpp"

namespace frit::io {
namespace {

constexpr std::size_t name_bytes = 16;

struct Header {
  std::array<char, name_bytes> name{};
  std::uint32_t version = 0, checksum = 0;
  std::uint64_t length = 0;
};
static_assert(sizeof(Header) == seal_bytes);

std::array<char, name_bytes> padded(std::string_view name) {
  FRIT_EXPECT(name.size() <= name_bytes);
  std::array<char, name_bytes> result{};
  std::copy(name.begin(), name.end(), result.begin());
  return result;
}

std::uint32_t checksum_of(std::uint32_t version, std::string_view contents) {
  const auto* head = reinterpret_cast<const Bytef*>(&version);
  const auto* body = reinterpret_cast<const Bytef*>(contents.data());
  return static_cast<std::uint32_t>(crc32_z(crc32_z(0, head, sizeof(version)), body, contents.size()));
}

}  // namespace

void seal(std::string& bytes, const Kind& kind) {
  FRIT_EXPECT(bytes.size() >= seal_bytes);
  const std::string_view contents = std::string_view(bytes).substr(seal_bytes);
  const Header header{padded(kind.name), kind.version, checksum_of(kind.version, contents), contents.size()};
  std::memcpy(bytes.data(), &header, sizeof(header));
}

Unsealed unseal(std::string_view bytes, const Kind& kind) {
  Header header;
  if (bytes.size() < seal_bytes) {
    const bool begins_so = !bytes.empty() && kind.name.starts_with(bytes.substr(0, kind.name.size()));
    return {begins_so ? SealState::damaged : SealState::foreign, 0, {}};
  }
  std::memcpy(&header, bytes.data(), sizeof(header));
  if (header.name != padded(kind.name)) return {SealState::foreign, 0, {}};
  const std::string_view contents = bytes.substr(seal_bytes);
  if (header.length != contents.size() || header.checksum != checksum_of(header.version, contents)) {
    return {SealState::damaged, header.version, {}};
  }
  if (header.version != kind.version) return {SealState::other_version, header.version, {}};
  return {SealState::intact, header.version, contents};
}

}  // namespace frit::io
