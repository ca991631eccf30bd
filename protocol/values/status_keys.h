// SPDX-License-Identifier: MIT
// The set of keys of the status object that a telemetry subscription requests.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "protocol/wire/names.h"

namespace hedgehog::protocol {

/// In the order of the status object.
enum class StatusKey : std::uint8_t {
  kDevice,
  kSimulated,
  kTimeNs,
  kState,
  kReason,
  kSinceS,
  kRemedy,
  kTemperatureC,
  kLimitA,
  kHeadroomS,
  kBurstS,
  kDerating,
  kCurrentA,
  kDuty,
  kSupplyV,
  kField,
  kForceN,
  kPin,
  kFan,
  kOrientation,
  kEffects,
  kLoop,
  kLink,
  kAppliedSeq,
  kLastTrip,
  kPins,
};

inline constexpr std::array<std::string_view, 26> kStatusKeyNames{
    "device",        "simulated", "time_ns",     "state",     "reason",   "since_s",     "remedy",
    "temperature_c", "limit_a",   "headroom_s",  "burst_s",   "derating", "current_a",   "duty",
    "supply_v",      "field",     "force_n",     "pin",       "fan",      "orientation", "effects",
    "loop",          "link",      "applied_seq", "last_trip", "pins"};

constexpr std::string_view name(StatusKey key) noexcept {
  return kStatusKeyNames[static_cast<std::size_t>(key)];
}
inline Names names_of(StatusKey) noexcept { return kStatusKeyNames; }

class StatusKeys {
 public:
  constexpr StatusKeys() noexcept = default;
  constexpr explicit StatusKeys(std::uint32_t bits) noexcept : bits_(bits) {}

  constexpr bool contains(StatusKey key) const noexcept { return (bits_ & bit(key)) != 0; }
  constexpr void add(StatusKey key) noexcept { bits_ |= bit(key); }
  constexpr bool empty() const noexcept { return bits_ == 0; }
  friend constexpr bool operator==(StatusKeys, StatusKeys) noexcept = default;

 private:
  static constexpr std::uint32_t bit(StatusKey key) noexcept {
    return std::uint32_t{1} << static_cast<unsigned>(key);
  }
  std::uint32_t bits_ = 0;
};

inline constexpr StatusKeys kEveryStatusKey{(std::uint32_t{1} << kStatusKeyNames.size()) - 1};
/// Keys of `device.status`, and of telemetry without `fields`: all except `pins`.
inline constexpr StatusKeys kTelemetryDefault{(std::uint32_t{1} << (kStatusKeyNames.size() - 1)) -
                                              1};

}  // namespace hedgehog::protocol
