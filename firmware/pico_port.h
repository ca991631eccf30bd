// SPDX-License-Identifier: MIT
// The `Port` of `board_millisecond` (daemon/device/board_core/port.h) on a Raspberry Pi Pico.
#pragma once

#include <stddef.h>
#include <stdint.h>

#include "daemon/device/board_core/frame.h"
#include "firmware/converter.h"
#include "firmware/pins.h"
#include "firmware/tach.h"
#include "firmware/usb/device.h"

namespace hedgehog::firmware {

class PicoPort {
 public:
  /// REQUIRES: clocks, peripherals and pins run, `set_serial` was called.
  void start() noexcept {
    start_converter();
    tach_.start();
    usb_.start();
  }

  /// What came while the loop slept.
  void poll() noexcept {
    usb_.poll();
    tach_.poll();
  }

  /// The slow part of `measure`, before the host's packets are taken.
  void convert() noexcept {
    raw_.tach_period_us = tach_.period_us();
    for (uint32_t k = 0; k < board::kWindings; ++k) {
      // The resolution of an edge's time is the interval of these polls.
      tach_.poll();
      converter_.measure(k, raw_);
    }
  }

  size_t receive(uint8_t* packet, size_t capacity) noexcept {
    const size_t length = usb_.receive(packet, capacity);
    if (length == board::kFrameSize &&
        packet[kTypeAt] == static_cast<uint8_t>(board::FrameType::kSetPoint))
      arrived_us_ = usb_.arrived_us();
    return length;
  }
  /// When the last set-point that was received had come.
  uint32_t arrived_us() const noexcept { return arrived_us_; }
  void measure(board::RawInputs& raw) noexcept {
    raw = raw_;
    raw.faults_low = faults_low();
  }
  void apply(const board::PinOutputs& pins) noexcept { set_pins(pins); }
  void send(const uint8_t* frame) noexcept {
    // A frame of the bus that began during the rules is handled first.
    usb_.poll();
    usb_.send(frame);
  }

 private:
  static constexpr size_t kTypeAt = 2;

  UsbDevice usb_;
  uint32_t arrived_us_ = 0;
  Converter converter_;
  Tach tach_;
  board::RawInputs raw_;
};

}  // namespace hedgehog::firmware
