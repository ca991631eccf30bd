// SPDX-License-Identifier: MIT
// A USB device as its host and the hub use it: its identity, its transfers and its time.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "emulator/usbip.h"

namespace hedgehog::emulator {

struct SetupPacket {
  std::uint8_t type = 0;
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
  std::uint16_t length = 0;
  static SetupPacket of(std::span<const Byte, 8> bytes) noexcept;
};

/// Requests of USB 2.0, chapter 9, and their types.
inline constexpr std::uint8_t kGetStatus = 0;
inline constexpr std::uint8_t kClearFeature = 1;
inline constexpr std::uint8_t kSetFeature = 3;
inline constexpr std::uint8_t kGetDescriptor = 6;
inline constexpr std::uint8_t kGetConfiguration = 8;
inline constexpr std::uint8_t kSetConfiguration = 9;
inline constexpr std::uint8_t kSetInterface = 11;
inline constexpr std::uint8_t kToHost = 0x80;
inline constexpr std::uint8_t kOfDevice = 0x00;
inline constexpr std::uint8_t kOfInterface = 0x01;
inline constexpr std::uint8_t kOfEndpoint = 0x02;

inline constexpr std::uint8_t kDeviceDescriptor = 1;
inline constexpr std::uint8_t kConfigurationDescriptor = 2;
inline constexpr std::uint8_t kStringDescriptor = 3;
inline constexpr std::uint8_t kInterfaceDescriptor = 4;
inline constexpr std::uint16_t kUsEnglish = 0x0409;

/// Bit of an endpoint's address: to the host.
inline constexpr std::uint8_t kIn = 0x80;

/// The emulator's thread. Runs also while unplugged: a board may have a supply of its own. A device
/// in another process throws std::runtime_error when that does not respond.
class EmulatedDevice {
 public:
  EmulatedDevice() = default;
  EmulatedDevice(const EmulatedDevice&) = delete;
  EmulatedDevice& operator=(const EmulatedDevice&) = delete;
  virtual ~EmulatedDevice() = default;

  virtual Exported exported() const = 0;
  virtual std::string product_name() const = 0;
  virtual std::string serial() const = 0;

  /// Advances by one millisecond.
  virtual void step() = 0;
  /// A command specific to this kind, split into words. Returns the response; nullopt: unknown
  /// command.
  virtual std::optional<std::string> command(std::span<const std::string> words);
  /// One JSON object on one line.
  virtual std::string status() const = 0;

  virtual void plugged() = 0;
  virtual void unplugged() {}

  /// Request on endpoint 0; nullopt: stall. `data`: of an OUT request.
  virtual std::optional<Bytes> control(const SetupPacket& setup, std::span<const Byte> data) = 0;
  /// False: a packet for this OUT endpoint has to wait.
  virtual bool accepts(std::uint8_t /*endpoint*/) const { return true; }
  /// REQUIRES: accepts(endpoint).
  virtual void out(std::uint8_t endpoint, std::span<const Byte> data) = 0;
  /// Removes and returns the oldest packet for the host.
  virtual std::optional<Bytes> take(std::uint8_t endpoint) = 0;
  /// The number of packets that the host has requested and not received.
  virtual void set_pending_reads(std::uint8_t /*endpoint*/, std::size_t /*count*/) {}

  /// Faults. A halted endpoint stalls until the host has cleared it `times` times; a silent device
  /// transfers nothing except on endpoint 0, but keeps running.
  virtual void halt(std::uint8_t address, int times) = 0;
  virtual bool halted(std::uint8_t address) const = 0;
  void set_silent(bool silent) noexcept { silent_ = silent; }
  bool silent() const noexcept { return silent_; }

 private:
  bool silent_ = false;
};

}  // namespace hedgehog::emulator
