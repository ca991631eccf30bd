// SPDX-License-Identifier: MIT
// Orientation from the reports of a HID sensor (usage page 0x20: Device Orientation, Relative
// Orientation). Source: HUTRR39 "HID Sensor Usages"; names of Linux' hid-sensor-ids.h. Pure.
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
  model::Quaternion quaternion;  // REP-103 -> world, z up; x points to the device's top edge
  std::optional<model::Vec3> rate_deg_s;  // missing if the report contains none
};

/// One orientation sensor of a device. Immutable; any thread.
class HidOrientation {
 public:
  /// nullopt if no input report contains a whole quaternion in an orientation collection. Of
  /// several, the one referenced to the world (Device Orientation) has precedence.
  static std::optional<HidOrientation> find(HidDescriptor descriptor);

  /// `report` as received: with its id byte in front if the device uses ids. nullopt for other
  /// reports, short ones, and invalid rotations (5 % off unit length).
  std::optional<HidOrientationSample> decode(std::span<const Byte> report) const;

  /// Ids of the feature reports that switch the sensor on; the caller reads each, passes it to
  /// `switch_on` (first byte: the id, 0 without ids), and sends it back.
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
