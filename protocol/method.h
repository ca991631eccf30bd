// SPDX-License-Identifier: MIT
// The methods of the protocol as one sorted table. What is not in it is answered with -32601.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "protocol/role.h"

namespace hedgehog::protocol {

/// In the order of their names, so that the enumerator is the index into `kMethods`.
enum class Method : std::uint8_t {
  kConnectionList,
  kDeviceArm,
  kDeviceClaim,
  kDeviceDescribe,
  kDeviceEmergencyStop,
  kDeviceList,
  kDeviceRelease,
  kDeviceStatus,
  kEffectCircle,
  kEffectHold,
  kEffectPlay,
  kEffectPreview,
  kEffectPulse,
  kEffectStop,
  kEffectStopAll,
  kEffectUpdate,
  kEffectVibrate,
  kEventsHistory,
  kEventsSubscribe,
  kEventsUnsubscribe,
  kHello,
  kOrientationRecenter,
  kOrientationSet,
  kOutputSetGain,
  kPatternGet,
  kPatternList,
  kPatternPut,
  kPatternRemove,
  kPing,
  kSimSet,
  kSimTruth,
  kTelemetrySubscribe,
  kTelemetryUnsubscribe,
  kThermalForecast,
};

struct MethodInfo {
  Method method;
  std::string_view name;
  /// The least role that may call it; none: anybody who can connect.
  std::optional<Role> role;
};

/// Sorted by name. Also the content of `hello.methods`.
inline constexpr std::array<MethodInfo, 34> kMethods{{
    {Method::kConnectionList, "connection.list", Role::kOperate},
    {Method::kDeviceArm, "device.arm", Role::kOperate},
    {Method::kDeviceClaim, "device.claim", Role::kOperate},
    {Method::kDeviceDescribe, "device.describe", Role::kObserve},
    {Method::kDeviceEmergencyStop, "device.emergency_stop", std::nullopt},
    {Method::kDeviceList, "device.list", Role::kObserve},
    {Method::kDeviceRelease, "device.release", Role::kOperate},
    {Method::kDeviceStatus, "device.status", Role::kObserve},
    {Method::kEffectCircle, "effect.circle", Role::kPlay},
    {Method::kEffectHold, "effect.hold", Role::kPlay},
    {Method::kEffectPlay, "effect.play", Role::kPlay},
    {Method::kEffectPreview, "effect.preview", Role::kObserve},
    {Method::kEffectPulse, "effect.pulse", Role::kPlay},
    {Method::kEffectStop, "effect.stop", Role::kPlay},
    {Method::kEffectStopAll, "effect.stop_all", Role::kPlay},
    {Method::kEffectUpdate, "effect.update", Role::kPlay},
    {Method::kEffectVibrate, "effect.vibrate", Role::kPlay},
    {Method::kEventsHistory, "events.history", Role::kObserve},
    {Method::kEventsSubscribe, "events.subscribe", Role::kObserve},
    {Method::kEventsUnsubscribe, "events.unsubscribe", Role::kObserve},
    {Method::kHello, "hello", std::nullopt},
    {Method::kOrientationRecenter, "orientation.recenter", Role::kPlay},
    {Method::kOrientationSet, "orientation.set", Role::kPlay},
    {Method::kOutputSetGain, "output.set_gain", Role::kOperate},
    {Method::kPatternGet, "pattern.get", Role::kObserve},
    {Method::kPatternList, "pattern.list", Role::kObserve},
    {Method::kPatternPut, "pattern.put", Role::kPlay},
    {Method::kPatternRemove, "pattern.remove", Role::kPlay},
    {Method::kPing, "ping", std::nullopt},
    {Method::kSimSet, "sim.set", Role::kOperate},
    {Method::kSimTruth, "sim.truth", Role::kOperate},
    {Method::kTelemetrySubscribe, "telemetry.subscribe", Role::kObserve},
    {Method::kTelemetryUnsubscribe, "telemetry.unsubscribe", Role::kObserve},
    {Method::kThermalForecast, "thermal.forecast", Role::kObserve},
}};

constexpr const MethodInfo& info(Method method) noexcept {
  return kMethods[static_cast<std::size_t>(method)];
}
constexpr std::string_view name(Method method) noexcept { return info(method).name; }
std::optional<Method> method_named(std::string_view text) noexcept;

}  // namespace hedgehog::protocol
