// SPDX-License-Identifier: MIT
#include "daemon/device/imu/hid_orientation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/units.h"

namespace hedgehog::device {
namespace {

using Kind = HidField::Kind;

constexpr HidUsage sensor(std::uint16_t usage) noexcept { return 0x200000u | usage; }

constexpr HidUsage kDeviceOrientation = sensor(0x8A);
constexpr HidUsage kRelativeOrientation = sensor(0x8E);
constexpr HidUsage kQuaternion = sensor(0x0483);
constexpr HidUsage kAngularVelocityX = sensor(0x0457);
constexpr HidUsage kReportInterval = sensor(0x030E);
constexpr HidUsage kReportingState = sensor(0x0316);
constexpr HidUsage kPowerState = sensor(0x0319);
constexpr HidUsage kReportAllEvents = sensor(0x0841);
constexpr HidUsage kFullPower = sensor(0x0851);

/// System nibble 2, "SI rotation": radians instead of degrees.
constexpr std::uint32_t kUnitRadians = 2;
constexpr double kMaxPlausibleDegS = 1e5;

bool contains(const std::vector<HidUsage>& usages, HidUsage usage) {
  return std::find(usages.begin(), usages.end(), usage) != usages.end();
}

/// Axes of a hand-held device, x to the right edge and y to the top edge, -> REP-103.
constexpr model::Vec3 to_rep103(const model::Vec3& v) noexcept { return {v.y, -v.x, v.z}; }
const model::Quaternion kFromRep103{std::sqrt(0.5), 0, 0, std::sqrt(0.5)};

/// Writes the selector `wanted` into an array field, or the second state (the first is "none") into
/// a plain number.
void choose(const HidField& field, HidUsage plain, HidUsage wanted, std::span<Byte> report) {
  if (field.variable) {
    if (field.usages.front() == plain) write_hid(field, 0, field.logical_min + 1, report);
    return;
  }
  const auto at = std::find(field.usages.begin(), field.usages.end(), wanted);
  if (at != field.usages.end())
    write_hid(field, 0, field.logical_min + (at - field.usages.begin()), report);
}

}  // namespace

std::optional<HidOrientation> HidOrientation::find(HidDescriptor descriptor) {
  HidOrientation made(std::move(descriptor));
  if (!made.take_quaternion(kDeviceOrientation) && !made.take_quaternion(kRelativeOrientation))
    return std::nullopt;
  made.take_rate();
  made.find_features();
  return made;
}

bool HidOrientation::take_quaternion(HidUsage collection) {
  std::size_t taken = 0;
  for (const HidElement& element : hid_elements(descriptor_, Kind::kInput, kQuaternion)) {
    const HidField& field = descriptor_.fields[element.field];
    if (!contains(field.collections, collection)) continue;
    // The four numbers of a quaternion are in one report.
    if (taken > 0 && field.report_id != report_id_) taken = 0;
    report_id_ = field.report_id;
    quaternion_[taken++] = element;
    if (taken == quaternion_.size()) {
      collection_ = collection;
      return true;
    }
  }
  return false;
}

void HidOrientation::take_rate() {
  std::array<HidElement, 3> axes;
  for (std::uint32_t axis = 0; axis < 3; ++axis) {
    const auto found = hid_elements(descriptor_, Kind::kInput, kAngularVelocityX + axis);
    const auto in_report = std::find_if(found.begin(), found.end(), [&](const HidElement& e) {
      return descriptor_.fields[e.field].report_id == report_id_;
    });
    if (in_report == found.end()) return;
    axes[axis] = *in_report;
  }
  rate_ = axes;
}

void HidOrientation::find_features() {
  for (const HidField& field : descriptor_.fields) {
    if (field.kind != Kind::kFeature || !contains(field.collections, collection_)) continue;
    const bool switches =
        contains(field.usages, kReportInterval) || contains(field.usages, kReportingState) ||
        contains(field.usages, kPowerState) || contains(field.usages, kReportAllEvents) ||
        contains(field.usages, kFullPower);
    const bool known =
        std::find(feature_ids_.begin(), feature_ids_.end(), field.report_id) != feature_ids_.end();
    if (switches && !known) feature_ids_.push_back(field.report_id);
  }
}

void HidOrientation::switch_on(std::span<Byte> report, double interval_s) const noexcept {
  if (report.empty()) return;
  const std::span<Byte> numbers = report.subspan(1);
  for (const HidField& field : descriptor_.fields) {
    if (field.kind != Kind::kFeature || field.report_id != report[0]) continue;
    if (!contains(field.collections, collection_)) continue;
    choose(field, kReportingState, kReportAllEvents, numbers);
    choose(field, kPowerState, kFullPower, numbers);
    if (field.variable && field.usages.front() == kReportInterval) {
      // Milliseconds, unless an exponent specifies otherwise.
      const double unit_s = 1e-3 * std::pow(10.0, field.exponent);
      const double wanted = std::clamp(interval_s / unit_s, 1.0, 60'000.0);
      write_hid(field, 0, std::llround(wanted), numbers);
    }
  }
}

std::optional<double> HidOrientation::value(const HidElement& element,
                                            std::span<const Byte> report) const {
  const HidField& field = descriptor_.fields[element.field];
  const auto raw = read_hid(field, element.index, report);
  if (!raw) return std::nullopt;
  return static_cast<double>(*raw) * std::pow(10.0, field.exponent);
}

std::optional<HidOrientationSample> HidOrientation::decode(std::span<const Byte> report) const {
  if (descriptor_.has_ids) {
    if (report.empty() || report[0] != report_id_) return std::nullopt;
    report = report.subspan(1);
  }
  std::array<double, 4> q{};
  for (std::size_t i = 0; i < q.size(); ++i) {
    const auto number = value(quaternion_[i], report);
    if (!number) return std::nullopt;
    q[i] = *number;
    // For devices that omit the exponent, the full range is 1.
    const HidField& field = descriptor_.fields[quaternion_[i].field];
    if (field.exponent == 0 && field.logical_max > 1)
      q[i] /= static_cast<double>(field.logical_max);
  }
  const model::Quaternion read{q[3], q[0], q[1], q[2]};
  const double length = norm(read);
  if (!(std::abs(length - 1.0) < 0.05)) return std::nullopt;
  HidOrientationSample sample;
  const double k = 1.0 / length;
  sample.quaternion =
      model::Quaternion{k * read.w, k * read.x, k * read.y, k * read.z} * kFromRep103;
  if (!rate_) return sample;

  model::Vec3 rate;
  for (int axis = 0; axis < 3; ++axis) {
    const HidElement& element = (*rate_)[static_cast<std::size_t>(axis)];
    const auto number = value(element, report);
    if (!number || std::abs(*number) > kMaxPlausibleDegS) return sample;
    const bool radians = (descriptor_.fields[element.field].unit & 0xF) == kUnitRadians;
    rate[axis] = radians ? model::kDegreesPerRadian * *number : *number;
  }
  sample.rate_deg_s = to_rep103(rate);
  return sample;
}

}  // namespace hedgehog::device
