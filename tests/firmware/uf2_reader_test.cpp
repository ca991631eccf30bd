// SPDX-License-Identifier: MIT
// `hedgehogctl board flash` accepts the files that the firmware's build writes.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cstdint>
#include <vector>

#include "clients/ctl/board/uf2_file.h"
#include "firmware/image/uf2.h"

namespace hedgehog::firmware {
namespace {

RC_GTEST_PROP(Uf2, EveryImageIsOneForTheBoard, ()) {
  const auto bytes = *rc::gen::inRange<std::size_t>(1, 70'000);
  const auto file = uf2(std::vector<std::uint8_t>(bytes, 0xA5), client::kFlashBegin);
  const auto image = client::read_uf2(file);
  RC_ASSERT(image.has_value());
  RC_ASSERT(image->bytes() >= bytes && image->bytes() < bytes + client::kUf2PayloadBytes);
  RC_ASSERT(image->end == client::kFlashBegin + image->bytes());
}

TEST(Uf2, AnImageLargerThanTheFlashIsNone) {
  const std::vector<std::uint8_t> full(client::kFlashBytes);
  EXPECT_TRUE(client::read_uf2(uf2(full, client::kFlashBegin)));
  const std::vector<std::uint8_t> larger(client::kFlashBytes + 1);
  EXPECT_FALSE(client::read_uf2(uf2(larger, client::kFlashBegin)));
}

}  // namespace
}  // namespace hedgehog::firmware
