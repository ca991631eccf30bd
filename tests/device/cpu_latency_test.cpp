// SPDX-License-Identifier: MIT
// The request to the kernel, with a file in place of its device.
#include "daemon/device/cpu_latency.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>

#include "tests/temporary_folder.h"

namespace hedgehog::device {
namespace {

constexpr const char* kDevice = "cpu_dma_latency";

TEST(CpuLatency, IsRequestedInMicrosecondsUntilNoLongerWanted) {
  const TemporaryFolder folder;
  CpuLatency latency(folder.write(kDevice, ""));
  latency.request(true);
  EXPECT_TRUE(latency.requested());
  std::int32_t written = 0;
  ASSERT_EQ(folder.read(kDevice).size(), sizeof written) << "the kernel takes four bytes";
  std::memcpy(&written, folder.read(kDevice).data(), sizeof written);
  EXPECT_EQ(written, CpuLatency::kLongestUs);
  latency.request(true);
  EXPECT_EQ(folder.read(kDevice).size(), sizeof written) << "once";
  latency.request(false);
  EXPECT_FALSE(latency.requested()) << "the request ends with its descriptor";
}

TEST(CpuLatency, IsTriedOnceWhereItIsNotAllowed) {
  const TemporaryFolder folder;
  CpuLatency latency(folder.path(kDevice));
  latency.request(true);
  EXPECT_FALSE(latency.requested());
  folder.write(kDevice, "");
  latency.request(false);
  latency.request(true);
  EXPECT_FALSE(latency.requested());
}

}  // namespace
}  // namespace hedgehog::device
