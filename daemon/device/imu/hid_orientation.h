// SPDX-License-Identifier: MIT
// Orientation out of the reports of a HID sensor (usage page 0x20: Device Orientation, Relative
// Orientation), wherever its descriptor says that the quaternion lies. Source: HUTRR39 "HID Sensor
// Usages"; the names of Linux' hid-sensor-ids.h. Pure.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "daemon/device/imu/hid_descriptor.h"
#include "model/quaternion.h"
#include "model/vec3.h"

namespace hedgehog::device {

struct HidOrientationSample {
  /// REP-103 -> world with z up: x where the top edge of the sensor's device points.
  model::Quaternion quaternion;
  /// Missing when the report has none.
  std::optional<model::Vec3> rate_deg_s;
};

/// One orientation sensor of a device. Immutable; any thread.
class HidOrientation {
 public:
  /// Nothing when no input report has a whole quaternion in an orientation collection. Of several,
  /// the one whose zero is the world (Device Orientation) is taken first.
  static std::optional<HidOrientation> find(HidDescriptor descriptor);

  /// `report` as it came: with its id byte in front if the device uses ids. Nothing for other
  /// reports, short ones, and numbers that are no rotation (5 % off unit length).
  std::optional<HidOrientationSample> decode(std::span<const Byte> report) const;

  /// Feature reports that switch it on, by id; the caller reads each, lets `switch_on` change it
  /// (first byte: the id, 0 without ids), and sends it back.
  const std::vector<std::uint8_t>& feature_ids() const noexcept { return feature_ids_; }
  std::size_t feature_bytes(std::uint8_t report_id) const noexcept {
    return 1 + descriptor_.report_bytes(HidField::Kind::kFeature, report_id);
  }
  void switch_on(std::span<Byte> report, double interval_s) const noexcept;

  std::uint8_t report_id() const noexcept { return report_id_; }

 private:
  explicit HidOrientation(HidDescriptor descriptor) : descriptor_(std::move(descriptor)) {}
  bool take_quaternion(HidUsage collection);
  void take_rate();
  void find_features();
  std::optional<double> value(const HidElement& element, std::span<const Byte> report) const;

  HidDescriptor descriptor_;
  HidUsage collection_ = 0;
  std::uint8_t report_id_ = 0;
  std::array<HidElement, 4> quaternion_{};
  std::optional<std::array<HidElement, 3>> rate_;
  std::vector<std::uint8_t> feature_ids_;
};

}  // namespace hedgehog::device
