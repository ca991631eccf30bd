// SPDX-License-Identifier: MIT
// Encoding of values as their changed words.
#include "daemon/control/recording/word_delta.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

namespace hedgehog::control {
namespace {

using Value = std::array<std::uint64_t, 51>;

std::vector<std::byte> encoded(WordDelta<Value>& delta, const Value& value) {
  std::array<std::byte, WordDelta<Value>::kMaxBytes> out;
  const std::size_t used = delta.encode(value, out);
  return {out.begin(), out.begin() + static_cast<std::ptrdiff_t>(used)};
}

RC_GTEST_PROP(WordDeltas, GiveEachValueBack,
              (const std::vector<std::vector<std::uint8_t>>& changes)) {
  WordDelta<Value> encoder;
  WordDelta<Value> decoder;
  Value value{};
  for (const auto& changed : changes) {
    for (const std::uint8_t at : changed) value[at % value.size()] ^= 1 + at;
    const auto bytes = encoded(encoder, value);
    Value read;
    RC_ASSERT(decoder.decode(bytes, read) == bytes.size());
    RC_ASSERT(read == value);
  }
}

TEST(WordDelta, UsesOneWordForTheUnchangedAndOneForEachChanged) {
  WordDelta<Value> delta;
  Value value{};
  EXPECT_EQ(encoded(delta, value).size(), 8u);
  value[3] = value[50] = 7;
  EXPECT_EQ(encoded(delta, value).size(), 24u);
  EXPECT_EQ(encoded(delta, value).size(), 8u);
  delta.restart();
  EXPECT_EQ(encoded(delta, value).size(), 24u)
      << "after a restart it needs nothing that was before";
}

TEST(WordDelta, RefusesTooFewBytesAndWordsThatAreNotOfTheValue) {
  WordDelta<Value> encoder;
  Value value{};
  value[0] = 1;
  auto bytes = encoded(encoder, value);
  WordDelta<Value> decoder;
  Value read;
  EXPECT_EQ(decoder.decode({}, read), 0u);
  EXPECT_EQ(decoder.decode(std::span(bytes).first(15), read), 0u);
  bytes[6] = std::byte{0x08};  // word 51
  bytes.resize(64);
  EXPECT_EQ(decoder.decode(bytes, read), 0u);
}

}  // namespace
}  // namespace hedgehog::control
