// SPDX-License-Identifier: MIT
// Requirements of the boot ROM and its mass storage on an image.
#include "firmware/image/uf2.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>
#include <string_view>
#include <vector>

namespace hedgehog::firmware {
namespace {

using testing::Each;
using testing::Eq;

std::uint32_t word(std::span<const std::uint8_t> bytes, std::size_t at) {
  return static_cast<std::uint32_t>(bytes[at] | bytes[at + 1] << 8 | bytes[at + 2] << 16) |
         static_cast<std::uint32_t>(bytes[at + 3]) << 24;
}

// The check value of the catalogue of parametrised CRC algorithms.
TEST(SecondStage, HasACrc32Mpeg2Checksum) {
  constexpr std::string_view kCheck = "123456789";
  const std::vector<std::uint8_t> bytes(kCheck.begin(), kCheck.end());
  EXPECT_EQ(crc32_mpeg2(bytes), 0x0376E6E7u);
}

TEST(SecondStage, IsPaddedAndEndsWithItsChecksum) {
  const auto stage = boot2_with_crc(std::vector<std::uint8_t>(100, 0xA5));
  ASSERT_TRUE(stage);
  ASSERT_EQ(stage->size(), 256u);
  const auto bytes = std::span(*stage);
  EXPECT_EQ(word(bytes, 252), crc32_mpeg2(bytes.first(252)));
  EXPECT_THAT(std::vector<std::uint8_t>(stage->begin() + 100, stage->begin() + 252), Each(Eq(0)));
}

TEST(SecondStage, HasAtMost252Bytes) {
  EXPECT_TRUE(boot2_with_crc(std::vector<std::uint8_t>(252)));
  EXPECT_FALSE(boot2_with_crc(std::vector<std::uint8_t>(253)));
}

TEST(Uf2, HasTheImageInNumberedBlocksForTheRp2040) {
  std::vector<std::uint8_t> image(600);
  std::iota(image.begin(), image.end(), std::uint8_t{1});
  const std::vector<std::uint8_t> file = uf2(image, 0x10000000);
  ASSERT_EQ(file.size(), 3u * 512u);
  for (std::uint32_t i = 0; i < 3; ++i) {
    const auto block = std::span(file).subspan(512 * i, 512);
    EXPECT_EQ(word(block, 0), 0x0A324655u);
    EXPECT_EQ(word(block, 4), 0x9E5D5157u);
    EXPECT_EQ(word(block, 8), 0x00002000u) << "bytes 28-31 are a family";
    EXPECT_EQ(word(block, 12), 0x10000000u + 256u * i);
    EXPECT_EQ(word(block, 16), 256u);
    EXPECT_EQ(word(block, 20), i);
    EXPECT_EQ(word(block, 24), 3u);
    EXPECT_EQ(word(block, 28), 0xE48BFF56u);
    EXPECT_EQ(block[32], image[256 * i]);
    EXPECT_EQ(word(block, 508), 0x0AB16F30u);
  }
}

}  // namespace
}  // namespace hedgehog::firmware
