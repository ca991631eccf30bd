// SPDX-License-Identifier: MIT
// What a HID device says about its reports: which bits of which report mean what, in which unit.
// Source: "Device Class Definition for Human Interface Devices" 1.11, sections 6.2.2 and 8. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "daemon/device/byte_order.h"

namespace hedgehog::device {

/// Usage page in the upper half, usage in the lower.
using HidUsage = std::uint32_t;

/// One main item: `count` numbers of `bits` bits each, one after the other.
struct HidField {
  enum class Kind : std::uint8_t { kInput, kOutput, kFeature };
  Kind kind = Kind::kInput;
  std::uint8_t report_id = 0;
  /// From the first byte behind the report id.
  std::uint32_t bit_offset = 0;
  std::uint32_t bits = 0;   // 1..32
  std::uint32_t count = 0;  // 1..kHidMaxCount
  std::int64_t logical_min = 0;
  std::int64_t logical_max = 0;
  /// value = number * 10^exponent in `unit`.
  int exponent = 0;
  std::uint32_t unit = 0;
  /// Variable: a usage for each number (the last one for all that follow). Array: the numbers
  /// select among the usages, `logical_min` being the first.
  bool variable = true;
  std::vector<HidUsage> usages;
  /// Of the collections around it, from the outermost.
  std::vector<HidUsage> collections;
};

inline constexpr std::uint32_t kHidMaxCount = 4096;

struct HidDescriptor {
  std::vector<HidField> fields;
  /// Every report with its length, padding included.
  struct Report {
    HidField::Kind kind = HidField::Kind::kInput;
    std::uint8_t id = 0;
    std::uint32_t bits = 0;
  };
  std::vector<Report> reports;
  /// False: reports have no id byte (hidapi then puts a 0 before feature reports).
  bool has_ids = false;

  /// Bytes of a report without its id; 0: there is none.
  std::size_t report_bytes(HidField::Kind kind, std::uint8_t report_id) const noexcept;
};

/// Nothing when it is not a descriptor: items cut off, collections or stacks out of balance, report
/// id 0, sizes beyond 64 KiB. Constant fields (padding) only move what follows.
std::optional<HidDescriptor> parse_hid_descriptor(std::span<const Byte> bytes);

/// Number `index` of the field in `report` (without its id byte), with its sign when `logical_min`
/// is negative. Nothing when the report is too short.
std::optional<std::int64_t> read_hid(const HidField& field, std::uint32_t index,
                                     std::span<const Byte> report) noexcept;
/// The reverse; false when the report is too short.
bool write_hid(const HidField& field, std::uint32_t index, std::int64_t value,
               std::span<Byte> report) noexcept;

/// One number of a field.
struct HidElement {
  std::size_t field = 0;  // index into HidDescriptor::fields
  std::uint32_t index = 0;
};
/// Every number of that kind and usage, in the order of the descriptor.
std::vector<HidElement> hid_elements(const HidDescriptor& descriptor, HidField::Kind kind,
                                     HidUsage usage);

}  // namespace hedgehog::device
