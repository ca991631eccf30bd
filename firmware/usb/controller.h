// SPDX-License-Identifier: MIT
// Memory and registers of the USB controller as a device (RP2040 data sheet 4.1).
#pragma once

#include <stdint.h>

#include "firmware/registers.h"

namespace hedgehog::firmware::usb_controller {

// 4.1.2.7.1, 4.1.4: the controller's memory.
inline constexpr uint32_t kEndpoint1InControl = kUsbMemory + 0x08;
inline constexpr uint32_t kEndpoint1OutControl = kUsbMemory + 0x0C;
inline constexpr uint32_t kIn0 = kUsbMemory + 0x80;
inline constexpr uint32_t kOut0 = kUsbMemory + 0x84;
inline constexpr uint32_t kIn1 = kUsbMemory + 0x88;
inline constexpr uint32_t kOut1 = kUsbMemory + 0x8C;
inline constexpr uint32_t kControlBuffer = 0x100;
inline constexpr uint32_t kOutBuffer = 0x180;
inline constexpr uint32_t kInBuffer = 0x1C0;
inline constexpr uint32_t kBulkEndpoint = (1u << 31) | (1u << 29) | (2u << 26);

// Buffer control.
inline constexpr uint32_t kFull = 1u << 15;
inline constexpr uint32_t kData1 = 1u << 13;
inline constexpr uint32_t kStall = 1u << 11;
inline constexpr uint32_t kAvailable = 1u << 10;
inline constexpr uint32_t kLength = 0x3FF;

// 4.1.4
inline constexpr uint32_t kAddress = kUsb + 0x00;
inline constexpr uint32_t kMainControl = kUsb + 0x40;
inline constexpr uint32_t kFrameNumber = kUsb + 0x48;
inline constexpr uint32_t kSieControl = kUsb + 0x4C;
inline constexpr uint32_t kSieStatus = kUsb + 0x50;
inline constexpr uint32_t kBuffers = kUsb + 0x58;
inline constexpr uint32_t kStallArm = kUsb + 0x68;
inline constexpr uint32_t kMuxing = kUsb + 0x74;
inline constexpr uint32_t kPower = kUsb + 0x78;
inline constexpr uint32_t kEnabledEvents = kUsb + 0x90;
inline constexpr uint32_t kEvents = kUsb + 0x98;

inline constexpr uint32_t kPullUp = 1u << 16;
inline constexpr uint32_t kStatusSetup = 1u << 17;
inline constexpr uint32_t kStatusReset = 1u << 19;
inline constexpr uint32_t kStatusSuspended = 1u << 4;

inline constexpr uint32_t kBufferEvent = 1u << 4;
inline constexpr uint32_t kResetEvent = 1u << 12;
inline constexpr uint32_t kSuspendEvent = 1u << 14;
inline constexpr uint32_t kSetupEvent = 1u << 16;
inline constexpr uint32_t kFrameEvent = 1u << 17;

inline constexpr uint32_t kIn0Done = 1u << 0;
inline constexpr uint32_t kOut0Done = 1u << 1;
inline constexpr uint32_t kIn1Done = 1u << 2;
inline constexpr uint32_t kOut1Done = 1u << 3;

}  // namespace hedgehog::firmware::usb_controller
