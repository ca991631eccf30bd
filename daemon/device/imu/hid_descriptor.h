// SPDX-License-Identifier: MIT
// HID report descriptors: position, meaning and unit of the fields of each report. Source: "Device
// Class Definition for Human Interface Devices" 1.11, sections 6.2.2 and 8. Pure.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "daemon/device/byte_order.h"

namespace hedgehog::device {

using HidUsage = std::uint32_t;  // usage page in the upper half, usage in the lower

/// One main item: `count` consecutive numbers of `bits` bits each.
struct HidField {
  enum class Kind : std::uint8_t { kInput, kOutput, kFeature };
  Kind kind = Kind::kInput;
  std::uint8_t report_id = 0;
  std::uint32_t bit_offset = 0;  // from the first byte after the report id
  std::uint32_t bits = 0;        // 1..32
  std::uint32_t count = 0;       // 1..kHidMaxCount
  std::int64_t logical_min = 0;
  std::int64_t logical_max = 0;
  int exponent = 0;  // value = number * 10^exponent in `unit`
  std::uint32_t unit = 0;
  /// Variable: a usage for each number (the last one for all that follow). Array: the numbers are
  /// indices of the usages, `logical_min` being the first.
  bool variable = true;
  std::vector<HidUsage> usages;
  std::vector<HidUsage> collections;  // usages of the enclosing collections, from the outermost
};

inline constexpr std::uint32_t kHidMaxCount = 4096;

struct HidDescriptor {
  std::vector<HidField> fields;
  struct Report {
    HidField::Kind kind = HidField::Kind::kInput;
    std::uint8_t id = 0;
    std::uint32_t bits = 0;  // padding included
  };
  std::vector<Report> reports;
  bool has_ids = false;  // false: no id byte (hidapi then puts a 0 before feature reports)

  /// Bytes of a report without its id; 0: no such report.
  std::size_t report_bytes(HidField::Kind kind, std::uint8_t report_id) const noexcept;
};

/// nullopt for an invalid descriptor: truncated items, unbalanced collections or stacks, report id
/// 0, sizes beyond 64 KiB. Constant fields (padding) only offset the following ones.
std::optional<HidDescriptor> parse_hid_descriptor(std::span<const Byte> bytes);

/// Number `index` of the field in `report` (without its id byte), signed if `logical_min` is
/// negative. nullopt if the report is too short.
std::optional<std::int64_t> read_hid(const HidField& field, std::uint32_t index,
                                     std::span<const Byte> report) noexcept;
/// The reverse; false if the report is too short.
bool write_hid(const HidField& field, std::uint32_t index, std::int64_t value,
               std::span<Byte> report) noexcept;

/// One number of a field.
struct HidElement {
  std::size_t field = 0;  // index into HidDescriptor::fields
  std::uint32_t index = 0;
};
/// All numbers of that kind and usage, in the order of the descriptor.
std::vector<HidElement> hid_elements(const HidDescriptor& descriptor, HidField::Kind kind,
                                     HidUsage usage);

}  // namespace hedgehog::device
