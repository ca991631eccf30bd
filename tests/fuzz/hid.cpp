// SPDX-License-Identifier: MIT
// Arbitrary bytes as a report descriptor (its length is the first byte) and as its reports.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "daemon/device/imu/hid_orientation.h"

namespace {

using namespace hedgehog::device;

void require(bool condition) {
  if (!condition) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const Byte* data, std::size_t size) {
  if (size < 2) return 0;
  const std::size_t length = std::min<std::size_t>(2 * std::size_t{data[0]}, size - 1);
  const auto descriptor = parse_hid_descriptor({data + 1, length});
  const std::span<const Byte> report(data + 1 + length, size - 1 - length);
  if (!descriptor) return 0;
  for (const HidField& field : descriptor->fields) {
    require(field.bits >= 1 && field.bits <= 32 && !field.usages.empty());
    require(field.count >= 1 && field.count <= kHidMaxCount);
    for (const std::uint32_t index : {0u, field.count - 1, field.count}) {
      const auto value = read_hid(field, index, report);
      if (!value) continue;
      std::vector<Byte> again(report.begin(), report.end());
      require(write_hid(field, index, *value, again));
      require(std::equal(again.begin(), again.end(), report.begin()));
    }
  }
  const auto sensor = HidOrientation::find(*descriptor);
  if (!sensor) return 0;
  if (const auto sample = sensor->decode(report)) {
    require(std::abs(norm(sample->quaternion) - 1.0) < 1e-9);
    require(!sample->rate_deg_s || is_finite(*sample->rate_deg_s));
  }
  for (const std::uint8_t id : sensor->feature_ids()) {
    std::vector<Byte> feature(sensor->feature_bytes(id));
    feature[0] = id;
    sensor->switch_on(feature, 0.01);
    require(feature[0] == id);
  }
  return 0;
}
