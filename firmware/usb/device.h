// SPDX-License-Identifier: MIT
// The USB controller (data sheet 4.1) as a full-speed device with one bulk endpoint each way. It
// has no interrupt handler: `poll` does what there is to do, whenever the main loop wakes.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "firmware/usb/packet_queue.h"
#include "firmware/usb/requests.h"
#include "firmware/usb/reset_exit.h"

namespace hedgehog::firmware {

class UsbDevice {
 public:
  /// REQUIRES: clocks run, `set_serial` was called.
  void start() noexcept;

  /// Takes what has arrived, answers requests, and arms what is to be sent. The host sees the
  /// device while its cable is in.
  void poll() noexcept;

  /// The next packet, of which as much as fits is copied; 65 for one of more than 64 bytes; 0:
  /// none.
  size_t receive(uint8_t* packet, size_t capacity) noexcept;
  /// When the packet of the last `receive` was noticed.
  uint32_t arrived_us() const noexcept { return received_.taken_arrived_us(); }
  /// 64 bytes; dropped while the last are still waiting, and while the bus is suspended.
  void send(const uint8_t* frame) noexcept;

  /// No frame of the bus, no packet, no suspend for so long, with a configured device whose bridges
  /// sleep: the controller hangs, and is reset. Longer than a resume or a hub's own restart.
  static constexpr uint32_t kHungUs = 2'000'000;

 private:
  void follow_vbus() noexcept;
  void check_progress(uint32_t events) noexcept;
  void restart() noexcept;
  void attach(bool wanted) noexcept;
  void handle_frame_start(uint32_t events) noexcept;
  void reset_bus_state() noexcept;
  void handle_setup() noexcept;
  void act(const UsbAnswer& answer) noexcept;
  void configure(bool configured) noexcept;
  void handle_buffers() noexcept;
  void handle_packet() noexcept;
  void continue_control() noexcept;
  void send_control_data() noexcept;
  void arm_out() noexcept;
  void discard_in() noexcept;
  void arm_in() noexcept;

  UsbRequests requests_;
  UsbResetExit reset_exit_;
  PacketQueue received_;

  /// What endpoint 0 has still to send, a packet of no bytes at the end included.
  Descriptor control_;
  bool control_ends_empty_ = false;
  enum class Control : uint8_t { kIdle, kSending, kAddressing } control_state_ = Control::kIdle;
  bool control_data1_ = false;
  uint8_t address_ = 0;

  bool attached_ = false;
  bool suspended_ = false;
  bool out_armed_ = false;
  bool out_halted_ = false;
  bool out_data1_ = false;
  bool in_armed_ = false;
  bool in_halted_ = false;
  bool in_data1_ = false;
  bool in_waiting_ = false;
  uint8_t in_frame_[PacketQueue::kPacketBytes] = {};

  /// The earliest that the last frame can have begun.
  uint32_t frame_start_us_ = 0;
  uint32_t polled_us_ = 0;
  /// Since when VBUS is other than `attached_`; of the last event.
  uint32_t vbus_changed_us_ = 0;
  uint32_t progress_us_ = 0;
};

}  // namespace hedgehog::firmware
