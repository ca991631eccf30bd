// SPDX-License-Identifier: MIT
#include "daemon/device/imu/hid_descriptor.h"

#include <algorithm>
#include <array>
#include <utility>

namespace hedgehog::device {
namespace {

using Kind = HidField::Kind;

// Tags of short items without the two size bits (HID 1.11 section 6.2.2).
enum Item : std::uint8_t {
  kInputItem = 0x80,
  kOutputItem = 0x90,
  kFeatureItem = 0xB0,
  kCollection = 0xA0,
  kEndCollection = 0xC0,
  kUsagePage = 0x04,
  kLogicalMin = 0x14,
  kLogicalMax = 0x24,
  kUnitExponent = 0x54,
  kUnit = 0x64,
  kReportSize = 0x74,
  kReportId = 0x84,
  kReportCount = 0x94,
  kPush = 0xA4,
  kPop = 0xB4,
  kUsage = 0x08,
  kUsageMin = 0x18,
  kUsageMax = 0x28,
  kLong = 0xFC,
};
constexpr std::size_t kDeepest = 64;
constexpr std::size_t kMaxUsages = 1024;
constexpr std::uint32_t kMaxBits = 65536 * 8;

struct Globals {
  std::uint32_t page = 0;
  std::int32_t logical_min = 0;
  std::int32_t logical_max = 0;
  std::uint32_t logical_max_unsigned = 0;
  int exponent = 0;
  std::uint32_t unit = 0;
  std::uint32_t bits = 0;
  std::uint32_t count = 0;
  std::uint8_t report_id = 0;
};

std::int32_t with_sign(std::uint32_t value, std::size_t size) noexcept {
  if (size == 1) return static_cast<std::int8_t>(value);
  if (size == 2) return static_cast<std::int16_t>(value);
  return static_cast<std::int32_t>(value);
}

/// A nibble in two's complement; some descriptors contain a signed byte instead.
int exponent_of(std::uint32_t value, std::size_t size) noexcept {
  if (value <= 7) return static_cast<int>(value);
  if (value <= 15) return static_cast<int>(value) - 16;
  return std::clamp(with_sign(value, size), -15, 15);
}

class Parser {
 public:
  std::optional<HidDescriptor> parse(std::span<const Byte> bytes) {
    while (!bytes.empty()) {
      const Byte prefix = bytes[0];
      if ((prefix & 0xFC) == kLong) {
        if (bytes.size() < 3 || bytes.size() < 3u + bytes[1]) return std::nullopt;
        bytes = bytes.subspan(3u + bytes[1]);
        continue;
      }
      const std::size_t size = std::array<std::size_t, 4>{0, 1, 2, 4}[prefix & 3];
      if (bytes.size() < 1 + size) return std::nullopt;
      std::uint32_t value = 0;
      for (std::size_t i = 0; i < size; ++i) value |= std::uint32_t{bytes[1 + i]} << (8 * i);
      if (!item(prefix & 0xFC, value, size)) return std::nullopt;
      bytes = bytes.subspan(1 + size);
    }
    if (!collections_.empty() || !stack_.empty()) return std::nullopt;
    return std::move(made_);
  }

 private:
  bool item(unsigned tag, std::uint32_t value, std::size_t size) {
    switch (tag) {
      case kInputItem:
        return field(Kind::kInput, value);
      case kOutputItem:
        return field(Kind::kOutput, value);
      case kFeatureItem:
        return field(Kind::kFeature, value);
      case kCollection:
        collections_.push_back(usages_.empty() ? 0 : usages_.front());
        clear_locals();
        return collections_.size() <= kDeepest;
      case kEndCollection:
        if (collections_.empty()) return false;
        collections_.pop_back();
        clear_locals();
        return true;
      case kPush:
        stack_.push_back(now_);
        return stack_.size() <= kDeepest;
      case kPop:
        if (stack_.empty()) return false;
        now_ = stack_.back();
        stack_.pop_back();
        return true;
      case kUsage:
        return usage(full(value, size));
      case kUsageMin:
        usage_min_ = full(value, size);
        return true;
      case kUsageMax:
        return usages(full(value, size));
      default:
        return global(tag, value, size);
    }
  }

  bool global(unsigned tag, std::uint32_t value, std::size_t size) {
    switch (tag) {
      case kUsagePage:
        now_.page = value;
        break;
      case kLogicalMin:
        now_.logical_min = with_sign(value, size);
        break;
      case kLogicalMax:
        now_.logical_max = with_sign(value, size);
        now_.logical_max_unsigned = value;
        break;
      case kUnitExponent:
        now_.exponent = exponent_of(value, size);
        break;
      case kUnit:
        now_.unit = value;
        break;
      case kReportSize:
        now_.bits = value;
        break;
      case kReportCount:
        now_.count = value;
        break;
      case kReportId:
        now_.report_id = static_cast<std::uint8_t>(value);
        made_.has_ids = true;
        return value >= 1 && value <= 255;
      default:
        break;  // physical ranges, designators, strings: not used
    }
    return true;
  }

  HidUsage full(std::uint32_t value, std::size_t size) const noexcept {
    return size == 4 ? value : now_.page << 16 | (value & 0xFFFF);
  }

  bool usage(HidUsage usage) {
    usages_.push_back(usage);
    return usages_.size() <= kMaxUsages;
  }

  bool usages(HidUsage last) {
    if (last < usage_min_ || last - usage_min_ > kMaxUsages) return true;  // as in keyboards
    for (HidUsage u = usage_min_; u <= last && u >= usage_min_; ++u)
      if (!usage(u)) return false;
    return true;
  }

  void clear_locals() {
    usages_.clear();
    usage_min_ = 0;
  }

  HidDescriptor::Report& report(Kind kind) {
    for (HidDescriptor::Report& known : made_.reports)
      if (known.kind == kind && known.id == now_.report_id) return known;
    return made_.reports.emplace_back(HidDescriptor::Report{kind, now_.report_id, 0});
  }

  bool field(Kind kind, std::uint32_t flags) {
    std::uint32_t& offset = report(kind).bits;
    const std::uint64_t length = std::uint64_t{now_.bits} * now_.count;
    if (length > kMaxBits - offset) return false;
    const bool constant = (flags & 1) != 0;
    const bool usable = now_.bits >= 1 && now_.bits <= 32 && now_.count >= 1 &&
                        now_.count <= kHidMaxCount && !usages_.empty();
    if (!constant && usable) {
      HidField made;
      made.kind = kind;
      made.report_id = now_.report_id;
      made.bit_offset = offset;
      made.bits = now_.bits;
      made.count = now_.count;
      made.logical_min = now_.logical_min;
      // A one-byte maximum of 255 is unsigned if the minimum is not negative.
      made.logical_max = now_.logical_min >= 0 && now_.logical_max < now_.logical_min
                             ? std::int64_t{now_.logical_max_unsigned}
                             : std::int64_t{now_.logical_max};
      made.exponent = now_.exponent;
      made.unit = now_.unit;
      made.variable = (flags & 2) != 0;
      made.usages = usages_;
      made.collections = collections_;
      made_.fields.push_back(std::move(made));
    }
    offset += static_cast<std::uint32_t>(length);
    clear_locals();
    return true;
  }

  HidDescriptor made_;
  Globals now_;
  std::vector<Globals> stack_;
  std::vector<HidUsage> collections_;
  std::vector<HidUsage> usages_;
  HidUsage usage_min_ = 0;
};

std::uint64_t first_bit(const HidField& field, std::uint32_t index) noexcept {
  return field.bit_offset + std::uint64_t{index} * field.bits;
}

}  // namespace

std::size_t HidDescriptor::report_bytes(Kind kind, std::uint8_t report_id) const noexcept {
  for (const Report& report : reports)
    if (report.kind == kind && report.id == report_id) return (report.bits + 7) / 8;
  return 0;
}

std::optional<HidDescriptor> parse_hid_descriptor(std::span<const Byte> bytes) {
  return Parser().parse(bytes);
}

std::optional<std::int64_t> read_hid(const HidField& field, std::uint32_t index,
                                     std::span<const Byte> report) noexcept {
  const std::uint64_t from = first_bit(field, index);
  if (index >= field.count || from + field.bits > report.size() * 8) return std::nullopt;
  std::uint64_t raw = 0;
  for (std::uint32_t bit = 0; bit < field.bits; ++bit) {
    const std::uint64_t at = from + bit;
    raw |= std::uint64_t{(report[at / 8] >> (at % 8)) & 1u} << bit;
  }
  const bool negative = field.logical_min < 0 && ((raw >> (field.bits - 1)) & 1) != 0;
  return static_cast<std::int64_t>(raw) - (negative ? std::int64_t{1} << field.bits : 0);
}

bool write_hid(const HidField& field, std::uint32_t index, std::int64_t value,
               std::span<Byte> report) noexcept {
  const std::uint64_t from = first_bit(field, index);
  if (index >= field.count || from + field.bits > report.size() * 8) return false;
  for (std::uint32_t bit = 0; bit < field.bits; ++bit) {
    const std::uint64_t at = from + bit;
    const auto mask = static_cast<Byte>(1u << (at % 8));
    const bool set = ((static_cast<std::uint64_t>(value) >> bit) & 1) != 0;
    report[at / 8] = static_cast<Byte>(set ? report[at / 8] | mask : report[at / 8] & ~mask);
  }
  return true;
}

std::vector<HidElement> hid_elements(const HidDescriptor& descriptor, Kind kind, HidUsage usage) {
  std::vector<HidElement> found;
  for (std::size_t f = 0; f < descriptor.fields.size(); ++f) {
    const HidField& field = descriptor.fields[f];
    if (field.kind != kind || !field.variable) continue;
    for (std::uint32_t i = 0; i < field.count; ++i) {
      const std::size_t u = std::min<std::size_t>(i, field.usages.size() - 1);
      if (field.usages[u] == usage) found.push_back({f, i});
    }
  }
  return found;
}

}  // namespace hedgehog::device
