// SPDX-License-Identifier: MIT
// device.*
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/method_info.h"
#include "protocol/methods/done.h"
#include "protocol/values/description.h"
#include "protocol/values/effect_params.h"
#include "protocol/values/status.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

/// The resulting state.
struct StateResult {
  static constexpr std::string_view kSchema = "State";
  std::string state{};
  std::optional<std::string> reason{};
  std::optional<std::string> remedy{};
  std::uint64_t seq = 0;
  std::optional<bool> on_disk{};  // emergency stop only: persisted over a restart

  void describe(Fields& f) {
    f.required("state", state);
    f.nullable("reason", reason);
    f.nullable("remedy", remedy);
    f.required("seq", seq);
    f.optional("on_disk", on_disk);
  }
  friend bool operator==(const StateResult&, const StateResult&) = default;
};

struct DeviceArm {
  static constexpr MethodInfo kMethod{"device.arm",
                                      Role::kOperate,
                                      "Arms the ball once the cause of the stop no longer exists.",
                                      {ErrorCode::kNotArmed, ErrorCode::kDeviceAbsent}};
  using Result = StateResult;
  friend bool operator==(const DeviceArm&, const DeviceArm&) = default;
};

struct DeviceEmergencyStop {
  static constexpr MethodInfo kMethod{"device.emergency_stop", std::nullopt,
                                      "Coils off at the next tick, latched until armed."};
  using Result = StateResult;
  friend bool operator==(const DeviceEmergencyStop&, const DeviceEmergencyStop&) = default;
};

struct DeviceEnterBootLoader {
  static constexpr MethodInfo kMethod{
      "device.enter_boot_loader",
      Role::kOperate,
      "Restarts the board in its boot loader, for a firmware update; rejected while armed.",
      {ErrorCode::kArmed, ErrorCode::kDeviceAbsent, ErrorCode::kUnsupported}};
  using Result = StateResult;
  friend bool operator==(const DeviceEnterBootLoader&, const DeviceEnterBootLoader&) = default;
};

struct ClaimResult {
  static constexpr std::string_view kSchema = "Claim";
  std::int64_t lease_ms = 0;

  void describe(Fields& f) { f.required("lease_ms", lease_ms); }
  friend bool operator==(const ClaimResult&, const ClaimResult&) = default;
};

/// Renewed by claiming again.
struct DeviceClaim {
  static constexpr MethodInfo kMethod{
      "device.claim",
      Role::kOperate,
      "Exclusive use of the ball until release, end of the connection, or expiry of the lease.",
      {ErrorCode::kClaimed}};
  using Result = ClaimResult;

  std::int64_t lease_ms = kMaxLeaseMs;

  void describe(Fields& f) {
    f.defaulted("lease_ms", lease_ms, {.min = kMinLeaseMs, .max = kMaxLeaseMs, .rounded = true});
  }
  friend bool operator==(const DeviceClaim&, const DeviceClaim&) = default;
};

struct DeviceRelease {
  static constexpr MethodInfo kMethod{"device.release", Role::kOperate, "Releases the claim."};
  using Result = Done;
  friend bool operator==(const DeviceRelease&, const DeviceRelease&) = default;
};

struct DeviceDescribe {
  static constexpr MethodInfo kMethod{"device.describe", Role::kObserve,
                                      "The ball: pins, coils, limits, calibration, identity."};
  using Result = Description;
  friend bool operator==(const DeviceDescribe&, const DeviceDescribe&) = default;
};

struct DeviceStatus {
  static constexpr MethodInfo kMethod{
      "device.status", Role::kObserve,
      "State of the ball: temperatures, currents, limits, effects."};
  using Result = Status;
  friend bool operator==(const DeviceStatus&, const DeviceStatus&) = default;
};

/// One USB or HID device that the daemon uses or could use.
struct SeenDevice {
  std::string path{};  // "USB 1-3", as the kernel names the port, or "Bluetooth"
  std::string ids{};   // "1209:0001"
  std::string name{};
  std::optional<std::string> serial{};
  std::optional<std::string> firmware{};
  std::optional<std::string> protocol{};  // boards only: "1"; "1.2" for the one in use
  std::optional<std::string> use{};       // "board", "imu", "thermometer"; null: not used
  std::optional<std::string> why_not{};   // a clause; null when it is used

  void describe(Fields& f) {
    f.required("path", path);
    f.required("ids", ids);
    f.required("name", name);
    f.nullable("serial", serial);
    f.nullable("firmware", firmware);
    f.nullable("protocol", protocol);
    f.nullable("use", use);
    f.nullable("why_not", why_not);
  }
  friend bool operator==(const SeenDevice&, const SeenDevice&) = default;
};

/// A configured device that is not connected.
struct MissingDevice {
  std::string use{};
  std::string why{};

  void describe(Fields& f) {
    f.required("use", use);
    f.required("why", why);
  }
  friend bool operator==(const MissingDevice&, const MissingDevice&) = default;
};

struct DevicesResult {
  static constexpr std::string_view kSchema = "Devices";
  std::vector<SeenDevice> devices{};
  std::vector<MissingDevice> missing{};
  std::int64_t others = 0;  // connected, but irrelevant to the daemon

  void describe(Fields& f) {
    f.required("devices", devices);
    f.required("missing", missing);
    f.required("others", others);
  }
  friend bool operator==(const DevicesResult&, const DevicesResult&) = default;
};

struct DeviceList {
  static constexpr MethodInfo kMethod{
      "device.list", Role::kObserve,
      "USB and HID devices: which are used, and why the others are not."};
  using Result = DevicesResult;
  friend bool operator==(const DeviceList&, const DeviceList&) = default;
};

using DeviceMethods = TypeList<DeviceArm, DeviceEmergencyStop, DeviceEnterBootLoader, DeviceClaim,
                               DeviceRelease, DeviceDescribe, DeviceStatus, DeviceList>;

}  // namespace hedgehog::protocol
