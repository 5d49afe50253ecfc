// Bytes behind a header that tells what they are, in which version, and whether a bit of them has changed.
//
// Header, 32 bytes, little endian: kind (16, filled with zeros), version (4), CRC-32 (4) of all that follows
// and of the version, length of what follows (8).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace frit::io {

inline constexpr std::size_t seal_bytes = 32;

struct Kind {
  std::string_view name;  // at most 16 characters
  std::uint32_t version;
};

// Fills the first seal_bytes of `bytes`, which the caller has left free before the contents.
void seal(std::string& bytes, const Kind& kind);

enum class SealState { intact, foreign, damaged, other_version };

// What a file turned out to be.
struct Unsealed {
  SealState state = SealState::foreign;
  std::uint32_t version = 0;
  std::string_view contents;  // of an intact one; points into the bytes
};
Unsealed unseal(std::string_view bytes, const Kind& kind);

}  // namespace frit::io
