#include "report/binary.hpp"

#include <gtest/gtest.h>
#include <zlib.h>

#include <random>

namespace frit::report {
namespace {

Bytes bytes_of(std::string_view text) { return {text.begin(), text.end()}; }

TEST(Base64, KnownTexts) {  // RFC 4648, section 10
  EXPECT_EQ(base64(bytes_of("")), "");
  EXPECT_EQ(base64(bytes_of("f")), "Zg==");
  EXPECT_EQ(base64(bytes_of("fo")), "Zm8=");
  EXPECT_EQ(base64(bytes_of("foo")), "Zm9v");
  EXPECT_EQ(base64(bytes_of("foobar")), "Zm9vYmFy");
  EXPECT_EQ(base64(Bytes{0xff, 0xef, 0xbe}), "/+++");
}

TEST(Varint, SevenBitsAByteLowestFirst) {
  Bytes bytes;
  for (const std::uint64_t value : {0u, 127u, 128u, 300u}) append_varint(bytes, value);
  EXPECT_EQ(bytes, (Bytes{0, 127, 0x80, 1, 0xac, 2}));
}

TEST(Zigzag, SmallOfEitherSignAreSmall) {
  EXPECT_EQ(zigzag(0), 0u);
  EXPECT_EQ(zigzag(-1), 1u);
  EXPECT_EQ(zigzag(1), 2u);
  EXPECT_EQ(zigzag(-2), 3u);
  EXPECT_EQ(zigzag(1000), 2000u);
}

TEST(Planes, LowBytesThenHighBytes) {
  Bytes bytes;
  append_planes(bytes, std::vector<std::uint16_t>{0x1234, 0xabcd});
  EXPECT_EQ(bytes, (Bytes{0x34, 0xcd, 0x12, 0xab}));
}

TEST(Deflate, ReadsBackTheSame) {
  std::mt19937 dice(3);
  for (const std::size_t size : {0u, 1u, 1000u, 100000u}) {
    Bytes bytes(size);
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(dice() % 7);
    const Bytes packed = deflate(bytes);
    Bytes back(size + 1);
    uLongf length = back.size();
    ASSERT_EQ(uncompress(back.data(), &length, packed.data(), packed.size()), Z_OK);
    back.resize(length);
    EXPECT_EQ(back, bytes);
  }
}

}  // namespace
}  // namespace frit::report
