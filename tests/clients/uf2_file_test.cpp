// SPDX-License-Identifier: MIT
// Which UF2 files are accepted for the board, and the errors for the others.
#include "clients/ctl/board/uf2_file.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <vector>

#include "tests/clients/uf2_sample.h"

namespace hedgehog::client {
namespace {

std::string refused(std::span<const std::uint8_t> file) {
  const auto image = read_uf2(file);
  if (image) return "taken";
  EXPECT_EQ(image.error().failure, Failure::kBadData);
  return image.error().message;
}
std::string refused(const Uf2Sample& sample) { return refused(sample.file()); }

/// The error for three pages with one wrong word in the second.
std::string refused(Uf2Word word, std::uint32_t value) {
  return refused(Uf2Sample::pages(3).put(1, word, value));
}

TEST(Uf2File, AcceptsPagesOfTheFlash) {
  EXPECT_EQ(read_uf2(Uf2Sample::pages(1).file()).value(), (Uf2Image{1, 0x10000100}));
  const Uf2Image image = read_uf2(Uf2Sample::pages(73).file()).value();
  EXPECT_EQ(image, (Uf2Image{73, 0x10004900}));
  EXPECT_EQ(image.bytes(), 18'688u);
  EXPECT_EQ(read_uf2(Uf2Sample::pages(8192).file()).value(), (Uf2Image{8192, 0x10200000}));
  EXPECT_EQ(read_uf2(Uf2Sample({0x10000000, 0x101FFF00}).file()).value().end, 0x10200000u);
}

TEST(Uf2File, AcceptsFlagsWithoutEffect) {
  // A check sum and tags may follow the payload.
  EXPECT_TRUE(read_uf2(Uf2Sample::pages(2).put(1, Uf2Word::kFlags, 0x0000E000).file()));
}

TEST(Uf2File, NamesTheProblemOfAFile) {
  EXPECT_EQ(refused(std::span<const std::uint8_t>()), "is empty");
  EXPECT_EQ(refused(std::vector<std::uint8_t>(1000)),
            "has 1000 bytes; a UF2 file has blocks of 512");
  EXPECT_EQ(refused(std::vector<std::uint8_t>(8193 * 512)),
            "has 8193 blocks, more than the 8192 of the flash");
  EXPECT_EQ(refused(std::vector<std::uint8_t>(512)),
            "block 0 is not a UF2 block: wrong magic numbers");
  EXPECT_EQ(refused(Uf2Sample({0x10000100, 0x10000200})),
            "has nothing for 0x10000000, where the chip starts");
}

TEST(Uf2File, NamesTheProblemOfABlock) {
  for (const Uf2Word word : {Uf2Word::kMagicFirst, Uf2Word::kMagicSecond, Uf2Word::kMagicLast})
    EXPECT_EQ(refused(word, 7), "block 1 is not a UF2 block: wrong magic numbers");
  EXPECT_EQ(refused(Uf2Word::kFlags, 0), "block 1 does not name the chip that it is for");
  EXPECT_EQ(refused(Uf2Word::kFlags, 0x2001), "block 1 is not for the flash");
  EXPECT_EQ(refused(Uf2Word::kFamily, 0xE48BFF59),
            "block 1 is for another chip, family 0xE48BFF59; the board's RP2040 is 0xE48BFF56");
  EXPECT_EQ(refused(Uf2Word::kBytes, 476), "block 1 has a payload of 476 bytes instead of 256");
  EXPECT_EQ(refused(Uf2Word::kCount, 4), "block 1 counts 4 blocks, and the file has 3");
  EXPECT_EQ(refused(Uf2Word::kNumber, 2), "block 1 has the number 2");
  EXPECT_EQ(refused(Uf2Word::kAddress, 0x20000000),
            "block 1 is for 0x20000000, outside the flash (0x10000000 to 0x101FFFFF)");
  EXPECT_EQ(refused(Uf2Word::kAddress, 0x10200000),
            "block 1 is for 0x10200000, outside the flash (0x10000000 to 0x101FFFFF)");
  EXPECT_EQ(refused(Uf2Word::kAddress, 0x0FFFFF00),
            "block 1 is for 0x0FFFFF00, outside the flash (0x10000000 to 0x101FFFFF)");
  EXPECT_EQ(refused(Uf2Word::kAddress, 0x10000180),
            "block 1 is for 0x10000180, which is no multiple of 256");
  EXPECT_EQ(refused(Uf2Word::kAddress, 0x10000000),
            "block 1 is for 0x10000000, as an earlier one is");
}

RC_GTEST_PROP(Uf2Laws, AnyPagesInAnyOrderAreAcceptedWithTheFirstAmongThem, ()) {
  auto pages = *rc::gen::unique<std::vector<std::uint32_t>>(rc::gen::inRange(1u, 8192u));
  pages.insert(pages.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(pages) + 1), 0u);
  std::vector<std::uint32_t> addresses;
  for (const std::uint32_t page : pages) addresses.push_back(0x10000000 + 256 * page);
  const auto image = read_uf2(Uf2Sample(addresses).file());
  RC_ASSERT(image.has_value());
  RC_ASSERT(image->blocks == pages.size());
  RC_ASSERT(image->end == *std::max_element(addresses.begin(), addresses.end()) + 256);
}

RC_GTEST_PROP(Uf2Laws, AWrongValueInABlocksHeaderIsRefused, ()) {
  const auto count = *rc::gen::inRange(1u, 20u);
  const auto block = *rc::gen::inRange(0u, count);
  const auto word =
      *rc::gen::element(Uf2Word::kMagicFirst, Uf2Word::kMagicSecond, Uf2Word::kMagicLast,
                        Uf2Word::kBytes, Uf2Word::kNumber, Uf2Word::kCount, Uf2Word::kFamily);
  const auto sample = Uf2Sample::pages(count);
  Uf2Sample other = sample;
  other.put(block, word, *rc::gen::arbitrary<std::uint32_t>());
  RC_ASSERT(read_uf2(other.file()).has_value() == (other.file() == sample.file()));
}

RC_GTEST_PROP(Uf2Laws, AnIncompleteFileIsRefused, ()) {
  const auto sample = Uf2Sample::pages(*rc::gen::inRange(1u, 20u));
  const auto size = *rc::gen::inRange<std::size_t>(0, sample.file().size());
  RC_ASSERT(!read_uf2(std::span(sample.file()).first(size)).has_value());
}

RC_GTEST_PROP(Uf2Laws, ThePayloadIsArbitrary, ()) {
  const auto bytes =
      *rc::gen::container<std::vector<std::uint8_t>>(256, rc::gen::arbitrary<std::uint8_t>());
  std::vector<std::uint8_t> file = Uf2Sample::pages(2).file();
  std::copy(bytes.begin(), bytes.end(), file.begin() + 512 + 32);
  RC_ASSERT(read_uf2(file).has_value());
}

}  // namespace
}  // namespace hedgehog::client
