// SPDX-License-Identifier: MIT
#include "clients/gamepad/uinput_device.h"

#include <fcntl.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstring>
#include <initializer_list>

#include "clients/gamepad/effect_player.h"

namespace hedgehog::gamepad {

namespace {

// From pid.codes, reserved for tests and private use.
constexpr std::uint16_t kVendor = 0x1209;
constexpr std::uint16_t kProduct = 0x0002;

Problem cannot_open(const std::string& path, int error) {
  std::string message = path + ": " + std::strerror(error);
  if (error == EACCES || error == EPERM)
    message += "; systemd/61-hedgehog-gamepad.rules gives it to the group hedgehog-gamepad";
  if (error == ENOENT || error == ENODEV) message += "; load the module: modprobe uinput";
  return {kUnavailable, message};
}

bool set_bits(int fd, unsigned long request, std::initializer_list<int> bits) {
  for (const int bit : bits)
    if (::ioctl(fd, request, bit) != 0) return false;
  return true;
}

bool set_up_axis(int fd, std::uint16_t code) {
  uinput_abs_setup axis{};
  axis.code = code;
  axis.absinfo.minimum = -kStickEnd;
  axis.absinfo.maximum = kStickEnd;
  return ::ioctl(fd, UI_ABS_SETUP, &axis) == 0;
}

}  // namespace

Result<std::unique_ptr<UinputDevice>> UinputDevice::create(const std::string& path) {
  const int fd = ::open(path.c_str(), O_RDWR | O_NONBLOCK | O_CLOEXEC);
  if (fd < 0) return cannot_open(path, errno);
  std::unique_ptr<UinputDevice> device(new UinputDevice(fd));
  if (!device->set_up())
    return Problem(kUnavailable, path + ": no gamepad can be made: " + std::strerror(errno));
  return device;
}

bool UinputDevice::set_up() const {
  uinput_setup setup{};
  setup.id = {BUS_VIRTUAL, kVendor, kProduct, 1};
  std::strncpy(setup.name, kGamepadName, sizeof setup.name - 1);
  setup.ff_effects_max = EffectPlayer::kMaxEffects;
  // Programs detect a gamepad by its buttons. The ball never presses them.
  return set_bits(fd_, UI_SET_EVBIT, {EV_KEY, EV_ABS, EV_FF}) &&
         set_bits(fd_, UI_SET_KEYBIT,
                  {BTN_SOUTH, BTN_EAST, BTN_NORTH, BTN_WEST, BTN_TL, BTN_TR, BTN_SELECT, BTN_START,
                   BTN_MODE, BTN_THUMBL, BTN_THUMBR}) &&
         set_bits(fd_, UI_SET_FFBIT,
                  {FF_RUMBLE, FF_CONSTANT, FF_PERIODIC, FF_RAMP, FF_SQUARE, FF_TRIANGLE, FF_SINE,
                   FF_SAW_UP, FF_SAW_DOWN, FF_GAIN}) &&
         set_bits(fd_, UI_SET_ABSBIT, {ABS_X, ABS_Y}) && set_up_axis(fd_, ABS_X) &&
         set_up_axis(fd_, ABS_Y) && ::ioctl(fd_, UI_DEV_SETUP, &setup) == 0 &&
         ::ioctl(fd_, UI_DEV_CREATE) == 0;
}

UinputDevice::~UinputDevice() {
  ::ioctl(fd_, UI_DEV_DESTROY);
  ::close(fd_);
}

Result<std::optional<DeviceCommand>> UinputDevice::next() {
  for (;;) {
    input_event event{};
    const ssize_t size = ::read(fd_, &event, sizeof event);
    if (size < 0 && errno == EINTR) continue;
    if (size < 0 && errno == EAGAIN) return std::optional<DeviceCommand>();
    if (size != sizeof event)
      return Problem(kUnavailable,
                     std::string("the gamepad device failed: ") + std::strerror(errno));
    if (auto taken = command(event)) return taken;
  }
}

std::optional<DeviceCommand> UinputDevice::command(const input_event& event) {
  if (event.type == EV_UINPUT) return request(event);
  if (event.type != EV_FF) return std::nullopt;
  if (event.code == FF_GAIN) return GainCommand{event.value};
  if (event.code >= EffectPlayer::kMaxEffects) return std::nullopt;
  return PlayCommand{event.code, event.value};
}

std::optional<DeviceCommand> UinputDevice::request(const input_event& event) {
  const auto number = static_cast<std::uint32_t>(event.value);
  if (event.code == UI_FF_UPLOAD) {
    upload_ = {};
    upload_.request_id = number;
    // The game may have timed out.
    if (::ioctl(fd_, UI_BEGIN_FF_UPLOAD, &upload_) != 0) return std::nullopt;
    return UploadRequest{number, upload_.effect};
  }
  if (event.code != UI_FF_ERASE) return std::nullopt;
  erase_ = {};
  erase_.request_id = number;
  if (::ioctl(fd_, UI_BEGIN_FF_ERASE, &erase_) != 0) return std::nullopt;
  return EraseRequest{number, erase_.effect_id};
}

void UinputDevice::answer_upload(const UploadRequest&, int error) {
  upload_.retval = -error;
  ::ioctl(fd_, UI_END_FF_UPLOAD, &upload_);
}

void UinputDevice::answer_erase(const EraseRequest&, int error) {
  erase_.retval = -error;
  ::ioctl(fd_, UI_END_FF_ERASE, &erase_);
}

void UinputDevice::move_stick(const StickPosition& position) {
  std::array<input_event, 3> events{};
  events[0].type = EV_ABS;
  events[0].code = ABS_X;
  events[0].value = position.x;
  events[1].type = EV_ABS;
  events[1].code = ABS_Y;
  events[1].value = position.y;
  events[2].type = EV_SYN;
  events[2].code = SYN_REPORT;
  // A failed write is corrected by the next position.
  [[maybe_unused]] const ssize_t written = ::write(fd_, events.data(), sizeof events);
}

}  // namespace hedgehog::gamepad
