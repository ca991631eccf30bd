// SPDX-License-Identifier: MIT
#include "firmware/usb/device.h"

#include "firmware/clocks.h"
#include "firmware/pins.h"
#include "firmware/registers.h"
#include "firmware/usb/controller.h"

namespace hedgehog::firmware {

using namespace usb_controller;

namespace {

constexpr uint16_t kControlPacket = 64;

/// Erratum RP2040-E15: a bulk packet of more than 50 bytes in the last fifth of a frame can hang
/// the controller. Without frames there is no such time.
constexpr uint32_t kArmBeforeUs = 800;
constexpr uint32_t kNoFramesUs = 2000;
/// A contact bounces for less; USB 2.0 7.1.7.3 allows 100 ms until the pull-up.
constexpr uint32_t kVbusSettledUs = 20'000;

volatile uint8_t* memory(uint32_t offset) noexcept {
  return reinterpret_cast<volatile uint8_t*>(kUsbMemory + offset);
}

/// 4.1.2.5.1: the controller may read a buffer's length only after all of it has crossed to its
/// clock.
void arm(uint32_t buffer, uint32_t value) noexcept {
  reg(buffer) = value;
  asm volatile("nop\nnop\nnop\nnop\nnop\nnop\nnop\nnop\nnop\nnop\nnop\nnop");
  reg(buffer) = value | kAvailable;
}

uint32_t pid(bool& data1) noexcept {
  const uint32_t bits = data1 ? kData1 : 0;
  data1 = !data1;
  return bits;
}

}  // namespace

void UsbDevice::start() noexcept {
  for (uint32_t offset = 0; offset < 0x200; offset += 4) reg(kUsbMemory + offset) = 0;
  reg(kMuxing) = (1u << 0) | (1u << 3);
  // The cable is watched at its pin: the controller shall think that it is always in.
  reg(kPower) = (1u << 2) | (1u << 3);
  reg(kMainControl) = 1;
  reg(kSieControl) = 1u << 29;
  reg(kEnabledEvents) = kBufferEvent | kResetEvent | kSuspendEvent | kSetupEvent | kFrameEvent;
  vbus_changed_us_ = now_us();
}

void UsbDevice::attach(bool wanted) noexcept {
  if (wanted == attached_) return;
  attached_ = wanted;
  // 7.1.5 of the specification: without VBUS nothing is pulled up. This board has no supply then;
  // one that is fed at VSYS has.
  reg(kSieControl) = (1u << 29) | (wanted ? kPullUp : 0);
  reset_bus_state();
}

void UsbDevice::follow_vbus() noexcept {
  const bool present = vbus_present();
  if (present == attached_)
    vbus_changed_us_ = now_us();
  else if (now_us() - vbus_changed_us_ >= kVbusSettledUs)
    attach(present);
}

/// A controller that hangs is known by its silence: a host sends a frame each millisecond, or it
/// suspends the device. Nothing but a reset of the controller ends it (erratum RP2040-E15).
void UsbDevice::check_progress(uint32_t events) noexcept {
  if (events != 0) suspended_ = (events & kSuspendEvent) != 0;
  const bool expected = requests_.configured() && !suspended_ && !bridges_awake();
  if (events != 0 || !expected)
    progress_us_ = now_us();
  else if (now_us() - progress_us_ >= kHungUs)
    restart();
}

void UsbDevice::restart() noexcept {
  restart_usb();
  // The pull-up is off from here on, until VBUS counts as settled again: the host sees the device
  // leave and come.
  attached_ = false;
  start();
  reset_bus_state();
}

void UsbDevice::poll() noexcept {
  follow_vbus();
  // A frame that begins after this is seen by the next poll at the latest.
  const uint32_t polled_us = now_us();
  const uint32_t events = reg(kEvents);
  check_progress(events);
  handle_frame_start(events);
  polled_us_ = polled_us;
  if ((events & kResetEvent) != 0) {
    clear_bits(kSieStatus, kStatusReset);
    reset_bus_state();
    reset_exit_.begin();
  }
  reset_exit_.poll();
  if ((events & kBufferEvent) != 0) handle_buffers();
  if ((events & kSuspendEvent) != 0) {
    clear_bits(kSieStatus, kStatusSuspended);
    discard_in();
  }
  if ((events & kSetupEvent) != 0) handle_setup();
  arm_in();
}

void UsbDevice::handle_frame_start(uint32_t events) noexcept {
  if ((events & kFrameEvent) != 0) {
    [[maybe_unused]] const uint32_t acknowledged = reg(kFrameNumber);
    frame_start_us_ = polled_us_;
  }
}

void UsbDevice::reset_bus_state() noexcept {
  reg(kAddress) = 0;
  requests_.reset();
  control_state_ = Control::kIdle;
  reg(kIn0) = 0;
  reg(kOut0) = 0;
  configure(false);
  reg(kBuffers) = ~0u;
}

void UsbDevice::handle_setup() noexcept {
  clear_bits(kSieStatus, kStatusSetup);
  const volatile uint8_t* bytes = memory(0);
  const auto word = [&](int at) { return static_cast<uint16_t>(bytes[at] | bytes[at + 1] << 8); };
  const SetupPacket setup{bytes[0], bytes[1], word(2), word(4), word(6)};
  // Whatever is left of the request before.
  reg(kIn0) = 0;
  reg(kOut0) = 0;
  reg(kBuffers) = kIn0Done | kOut0Done;
  control_state_ = Control::kIdle;
  const UsbAnswer answer = requests_.answer(setup);
  if (answer.stalled) {
    reg(kStallArm) = 3;
    reg(kIn0) = kStall;
    reg(kOut0) = kStall;
    return;
  }
  act(answer);
  control_data1_ = true;
  control_ = answer.data;
  if (control_.length > setup.length) control_.length = setup.length;
  if (answer.data.bytes == nullptr || setup.length == 0) {
    arm(kIn0, kFull | kData1);
    return;
  }
  control_state_ = Control::kSending;
  control_ends_empty_ = control_.length < setup.length && control_.length % kControlPacket == 0;
  send_control_data();
}

void UsbDevice::act(const UsbAnswer& answer) noexcept {
  const bool in = (answer.argument & 0x80) != 0;
  const bool halt = answer.action == UsbAction::kHalt;
  switch (answer.action) {
    case UsbAction::kNone:
      return;
    case UsbAction::kSetAddress:
      address_ = answer.argument;
      control_state_ = Control::kAddressing;
      return;
    case UsbAction::kConfigure:
      configure(answer.argument != 0);
      return;
    case UsbAction::kHalt:
    case UsbAction::kClearHalt:
      // Either way the endpoint begins anew with DATA0.
      reg(in ? kIn1 : kOut1) = halt ? kStall : 0;
      reg(kBuffers) = in ? kIn1Done : kOut1Done;
      (in ? in_halted_ : out_halted_) = halt;
      (in ? in_data1_ : out_data1_) = false;
      (in ? in_armed_ : out_armed_) = false;
      if (!in) arm_out();
      return;
  }
}

void UsbDevice::configure(bool configured) noexcept {
  reg(kIn1) = 0;
  reg(kOut1) = 0;
  // What was completed since the buffers were handled is not that of those armed from here on.
  reg(kBuffers) = kIn1Done | kOut1Done;
  reg(kEndpoint1InControl) = configured ? kBulkEndpoint | kInBuffer : 0;
  reg(kEndpoint1OutControl) = configured ? kBulkEndpoint | kOutBuffer : 0;
  received_.clear();
  in_halted_ = out_halted_ = false;
  in_data1_ = out_data1_ = false;
  in_armed_ = out_armed_ = false;
  in_waiting_ = false;
  arm_out();
}

void UsbDevice::handle_buffers() noexcept {
  const uint32_t done = reg(kBuffers);
  reg(kBuffers) = done;
  if ((done & kIn0Done) != 0) continue_control();
  if ((done & kIn1Done) != 0) in_armed_ = false;
  if ((done & kOut1Done) != 0) handle_packet();
}

void UsbDevice::handle_packet() noexcept {
  if (!out_armed_) return;
  out_armed_ = false;
  const size_t length = reg(kOut1) & kLength;
  if (length != 0) received_.put(memory(kOutBuffer), length, now_us());
  arm_out();
}

void UsbDevice::continue_control() noexcept {
  switch (control_state_) {
    case Control::kIdle:
      return;
    case Control::kAddressing:
      // 9.4.6 of the specification: the new address holds after the status stage.
      reg(kAddress) = address_;
      control_state_ = Control::kIdle;
      return;
    case Control::kSending:
      if (control_.length != 0 || control_ends_empty_) {
        if (control_.length == 0) control_ends_empty_ = false;
        send_control_data();
        return;
      }
      control_state_ = Control::kIdle;
      arm(kOut0, kData1);
      return;
  }
}

void UsbDevice::send_control_data() noexcept {
  const uint16_t length = control_.length < kControlPacket ? control_.length : kControlPacket;
  volatile uint8_t* buffer = memory(kControlBuffer);
  for (uint16_t i = 0; i < length; ++i) buffer[i] = control_.bytes[i];
  control_.bytes += length;
  control_.length = static_cast<uint16_t>(control_.length - length);
  arm(kIn0, kFull | pid(control_data1_) | length);
}

void UsbDevice::arm_out() noexcept {
  if (!requests_.configured() || out_armed_ || out_halted_ || !received_.has_capacity()) return;
  out_armed_ = true;
  arm(kOut1, pid(out_data1_) | PacketQueue::kPacketBytes);
}

size_t UsbDevice::receive(uint8_t* packet, size_t capacity) noexcept {
  const size_t length = received_.take(packet, capacity);
  arm_out();
  return length;
}

void UsbDevice::send(const uint8_t* frame) noexcept {
  if (!requests_.configured() || suspended_ || in_waiting_ || in_armed_) return;
  for (size_t i = 0; i < sizeof(in_frame_); ++i) in_frame_[i] = frame[i];
  in_waiting_ = true;
  arm_in();
}

/// What would be sent after a resume is too old by then. The bus has been idle for 3 ms: the
/// controller is not sending it.
void UsbDevice::discard_in() noexcept {
  in_waiting_ = false;
  if (!in_armed_) return;
  reg(kIn1) = 0;
  in_armed_ = false;
  in_data1_ = !in_data1_;
}

void UsbDevice::arm_in() noexcept {
  if (!requests_.configured() || !in_waiting_ || in_armed_ || in_halted_) return;
  const uint32_t into_frame_us = now_us() - frame_start_us_;
  if (into_frame_us >= kArmBeforeUs && into_frame_us < kNoFramesUs) return;
  volatile uint8_t* buffer = memory(kInBuffer);
  for (size_t i = 0; i < sizeof(in_frame_); ++i) buffer[i] = in_frame_[i];
  in_waiting_ = false;
  in_armed_ = true;
  arm(kIn1, kFull | pid(in_data1_) | sizeof(in_frame_));
}

}  // namespace hedgehog::firmware
