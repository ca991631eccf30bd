// SPDX-License-Identifier: MIT
// The driver's side of a gamepad device.
#pragma once

#include <linux/input.h>

#include <cstdint>
#include <optional>
#include <variant>

#include "clients/common/problem.h"
#include "clients/gamepad/tilt_axes.h"

namespace hedgehog::gamepad {

/// A game uploads `effect`, whose `id` is its index, and waits for `answer_upload`.
struct UploadRequest {
  std::uint32_t request = 0;
  ff_effect effect{};
};
/// A game erases an effect, or has closed its handle, and waits for `answer_erase`.
struct EraseRequest {
  std::uint32_t request = 0;
  std::uint32_t id = 0;
};
struct PlayCommand {
  std::uint16_t id = 0;
  std::int32_t count = 0;  // 0: stop
};
struct GainCommand {
  std::int32_t gain = 0;  // 0..0xffff
};
using DeviceCommand = std::variant<UploadRequest, EraseRequest, PlayCommand, GainCommand>;

/// Calls do not block. One thread.
class GamepadDevice {
 public:
  GamepadDevice() = default;
  GamepadDevice(const GamepadDevice&) = delete;
  GamepadDevice& operator=(const GamepadDevice&) = delete;
  virtual ~GamepadDevice() = default;

  /// Readable while `next` has a command.
  virtual int descriptor() const noexcept = 0;
  /// The oldest unread command; nullopt: there is none.
  virtual Result<std::optional<DeviceCommand>> next() = 0;
  /// `error`: an errno, 0 for success.
  virtual void answer_upload(const UploadRequest& request, int error) = 0;
  virtual void answer_erase(const EraseRequest& request, int error) = 0;
  /// Sets the position of the stick.
  virtual void move_stick(const StickPosition& position) = 0;
};

}  // namespace hedgehog::gamepad
