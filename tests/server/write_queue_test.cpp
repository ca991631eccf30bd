// SPDX-License-Identifier: MIT
#include "daemon/server/session/write_queue.h"

#include <gtest/gtest.h>

#include <string>

namespace hedgehog::server {
namespace {

constexpr std::size_t kMax = 1000;

std::string drain(WriteQueue& queue) {
  std::string all;
  while (!queue.empty()) {
    all += queue.take();
    queue.sent();
  }
  return all;
}

TEST(WriteQueue, SendsInOrderWithLineEnds) {
  WriteQueue queue(kMax);
  EXPECT_TRUE(queue.push("a", LineKind::kResponse));
  EXPECT_TRUE(queue.push("b", LineKind::kTelemetry));
  EXPECT_TRUE(queue.push("c", LineKind::kEvent));
  EXPECT_EQ(queue.bytes(), 6u);
  EXPECT_EQ(drain(queue), "a\nb\nc\n");
  EXPECT_EQ(queue.bytes(), 0u);
}

TEST(WriteQueue, ASlowReaderLosesTelemetryFirst) {
  WriteQueue queue(kMax);
  for (int i = 0; i < 20; ++i) EXPECT_TRUE(queue.push(std::string(99, 't'), LineKind::kTelemetry));
  EXPECT_EQ(queue.bytes(), 500u);  // half of the limit
  EXPECT_EQ(queue.telemetry_dropped(), 15u);
}

TEST(WriteQueue, ResponsesAndEventsDisplaceTelemetry) {
  WriteQueue queue(kMax);
  for (int i = 0; i < 5; ++i) EXPECT_TRUE(queue.push(std::string(99, 't'), LineKind::kTelemetry));
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(queue.push(std::string(99, 'e'), LineKind::kEvent));
  EXPECT_EQ(drain(queue).find('t'), std::string::npos);
}

TEST(WriteQueue, AReaderThatReadsNothingIsDisconnected) {
  WriteQueue queue(kMax);
  for (int i = 0; i < 10; ++i) EXPECT_TRUE(queue.push(std::string(99, 'e'), LineKind::kEvent));
  EXPECT_FALSE(queue.push("e", LineKind::kEvent));
}

TEST(WriteQueue, ResponsesAreCountedUntilTheyAreSent) {
  WriteQueue queue(kMax);
  EXPECT_TRUE(queue.push(std::string(99, 't'), LineKind::kTelemetry));
  EXPECT_TRUE(queue.push(std::string(99, 'e'), LineKind::kEvent));
  EXPECT_EQ(queue.response_bytes(), 0u);
  EXPECT_TRUE(queue.push(std::string(99, 'a'), LineKind::kResponse));
  queue.take();
  EXPECT_TRUE(queue.push(std::string(49, 'a'), LineKind::kResponse));
  EXPECT_EQ(queue.response_bytes(), 150u);
  queue.sent();
  EXPECT_EQ(queue.response_bytes(), 50u);
  queue.take_one();
  queue.sent();
  EXPECT_EQ(queue.response_bytes(), 0u);
}

TEST(WriteQueue, TheLineBeingSentStaysInPlace) {
  WriteQueue queue(kMax);
  EXPECT_TRUE(queue.push(std::string(299, 't'), LineKind::kTelemetry));
  const std::string& sending = queue.take();
  const char* const at = sending.data();
  for (int i = 0; i < 7; ++i) EXPECT_TRUE(queue.push(std::string(99, 'e'), LineKind::kEvent));
  EXPECT_FALSE(queue.push(std::string(99, 'e'), LineKind::kEvent));
  EXPECT_EQ(sending.data(), at);
  EXPECT_EQ(sending, std::string(299, 't') + "\n");
}

}  // namespace
}  // namespace hedgehog::server
