// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
// What the daemon understands and tells.
#pragma once

namespace hedgehog::unreal::methods {

inline constexpr const char* kConnectionList = "connection.list";
inline constexpr const char* kDeviceArm = "device.arm";
inline constexpr const char* kDeviceClaim = "device.claim";
inline constexpr const char* kDeviceDescribe = "device.describe";
inline constexpr const char* kDeviceEmergencyStop = "device.emergency_stop";
inline constexpr const char* kDeviceEnterBootLoader = "device.enter_boot_loader";
inline constexpr const char* kDeviceList = "device.list";
inline constexpr const char* kDeviceRelease = "device.release";
inline constexpr const char* kDeviceStatus = "device.status";
inline constexpr const char* kEffectCircle = "effect.circle";
inline constexpr const char* kEffectHold = "effect.hold";
inline constexpr const char* kEffectLatency = "effect.latency";
inline constexpr const char* kEffectPlay = "effect.play";
inline constexpr const char* kEffectPreview = "effect.preview";
inline constexpr const char* kEffectPulse = "effect.pulse";
inline constexpr const char* kEffectStop = "effect.stop";
inline constexpr const char* kEffectStopAll = "effect.stop_all";
inline constexpr const char* kEffectUpdate = "effect.update";
inline constexpr const char* kEffectVibrate = "effect.vibrate";
inline constexpr const char* kEventsHistory = "events.history";
inline constexpr const char* kEventsSubscribe = "events.subscribe";
inline constexpr const char* kEventsUnsubscribe = "events.unsubscribe";
inline constexpr const char* kHello = "hello";
inline constexpr const char* kOrientationRecenter = "orientation.recenter";
inline constexpr const char* kOrientationSet = "orientation.set";
inline constexpr const char* kOutputSetGain = "output.set_gain";
inline constexpr const char* kPatternGet = "pattern.get";
inline constexpr const char* kPatternList = "pattern.list";
inline constexpr const char* kPatternPut = "pattern.put";
inline constexpr const char* kPatternRemove = "pattern.remove";
inline constexpr const char* kPing = "ping";
inline constexpr const char* kSimSet = "sim.set";
inline constexpr const char* kSimTruth = "sim.truth";
inline constexpr const char* kTelemetryHistory = "telemetry.history";
inline constexpr const char* kTelemetrySubscribe = "telemetry.subscribe";
inline constexpr const char* kTelemetryUnsubscribe = "telemetry.unsubscribe";
inline constexpr const char* kThermalForecast = "thermal.forecast";

/// The types of events.
inline constexpr const char* kEvents[] = {
    "derating_ended",
    "derating_started",
    "device_attached",
    "device_detached",
    "effect_ended",
    "effect_started",
    "measurement_accepted",
    "measurement_rejected",
    "orientation_lost",
    "orientation_restored",
    "overrun",
    "shutting_down",
    "state_changed",
};

}  // namespace hedgehog::unreal::methods
