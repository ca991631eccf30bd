// SPDX-License-Identifier: MIT
// A gamepad created by Linux' uinput (include/uapi/linux/uinput.h).
#pragma once

#include <linux/uinput.h>

#include <memory>
#include <string>

#include "clients/gamepad/gamepad_device.h"

namespace hedgehog::gamepad {

inline constexpr const char* kUinputPath = "/dev/uinput";
/// Name shown by games.
inline constexpr const char* kGamepadName = "Hedgehog haptic ball";

/// The device exists as long as this object.
class UinputDevice : public GamepadDevice {
 public:
  /// kUnavailable if `path` cannot be opened or is not uinput; the message contains a remedy.
  static Result<std::unique_ptr<UinputDevice>> create(const std::string& path = kUinputPath);
  ~UinputDevice() override;

  int descriptor() const noexcept override { return fd_; }
  Result<std::optional<DeviceCommand>> next() override;
  void answer_upload(const UploadRequest& request, int error) override;
  void answer_erase(const EraseRequest& request, int error) override;
  void move_stick(const StickPosition& position) override;

 private:
  explicit UinputDevice(int fd) : fd_(fd) {}
  /// False, with errno set, if it fails.
  bool set_up() const;
  std::optional<DeviceCommand> command(const input_event& event);
  std::optional<DeviceCommand> request(const input_event& event);

  int fd_ = -1;
  uinput_ff_upload upload_{};  // begun and not answered yet
  uinput_ff_erase erase_{};
};

}  // namespace hedgehog::gamepad
