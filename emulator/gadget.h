// SPDX-License-Identifier: MIT
// The device side of a USB device: descriptors, control requests on endpoint 0, and packets of its
// other endpoints. Transport: HostSession.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emulator/usbip.h"

namespace hedgehog::emulator {

struct EndpointShape {
  /// Bit 7: IN.
  std::uint8_t address = 0;
  bool bulk = false;  // else interrupt, polled every millisecond
  std::uint16_t bytes = 64;
};

struct InterfaceShape {
  std::uint8_t code = 0xFF;
  std::uint8_t subclass = 0;
  std::uint8_t protocol = 0;
  std::vector<EndpointShape> endpoints;
  /// HID interfaces only.
  Bytes report_descriptor;
};

struct GadgetShape {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  std::string manufacturer;
  std::string name;
  std::string serial;
  std::vector<InterfaceShape> interfaces;
};

struct SetupPacket {
  std::uint8_t type = 0;
  std::uint8_t request = 0;
  std::uint16_t value = 0;
  std::uint16_t index = 0;
  std::uint16_t length = 0;
  static SetupPacket of(std::span<const Byte, 8> bytes) noexcept;
};

/// The emulator's thread. Runs also while unplugged: a board has its own supply.
class Gadget {
 public:
  explicit Gadget(GadgetShape shape) : shape_(std::move(shape)) {}
  Gadget(const Gadget&) = delete;
  Gadget& operator=(const Gadget&) = delete;
  virtual ~Gadget() = default;

  const GadgetShape& shape() const noexcept { return shape_; }
  Exported exported() const;

  /// Advances by one millisecond.
  virtual void step() = 0;
  /// A command specific to this kind, split into words. Returns the response; nullopt: unknown
  /// command.
  virtual std::optional<std::string> command(std::span<const std::string> words);
  /// One JSON object on one line.
  virtual std::string status() const = 0;

  /// Resets queues and halts when it is plugged in.
  void plugged() noexcept;
  /// Request on endpoint 0; nullopt: stall. `data`: of an OUT request.
  std::optional<Bytes> control(const SetupPacket& setup, std::span<const Byte> data);
  void out(std::uint8_t endpoint, std::span<const Byte> data);
  /// Removes and returns the oldest packet queued for the host.
  std::optional<Bytes> take(std::uint8_t endpoint);

  /// Faults. A halted endpoint stalls until the host has cleared it `times` times; a silent device
  /// transfers nothing except on endpoint 0, but keeps running.
  void halt(std::uint8_t address, int times) { halts_[address] = times; }
  bool halted(std::uint8_t address) const;
  void set_silent(bool silent) noexcept { silent_ = silent; }
  bool silent() const noexcept { return silent_; }

 protected:
  /// Queues a packet for the host. If more than `kWaiting` are queued, the oldest is lost.
  void give(std::uint8_t endpoint, Bytes packet);
  static constexpr std::size_t kWaiting = 4;
  std::uint64_t lost() const noexcept { return lost_; }

  /// Class and vendor requests; nullopt: stall.
  virtual std::optional<Bytes> handle_control(const SetupPacket& setup, std::span<const Byte> data);
  virtual void handle_out(std::uint8_t endpoint, std::span<const Byte> data) = 0;

 private:
  Bytes device_descriptor() const;
  Bytes configuration_descriptor() const;
  std::optional<Bytes> string_descriptor(std::size_t index) const;
  std::optional<Bytes> descriptor(const SetupPacket& setup) const;
  bool clear_halt(std::uint8_t address);

  GadgetShape shape_;
  std::map<std::uint8_t, std::deque<Bytes>> waiting_;
  std::map<std::uint8_t, int> halts_;
  bool silent_ = false;
  std::uint64_t lost_ = 0;
};

/// Requests of HID devices.
inline constexpr std::uint8_t kHidToHost = 0xA1;
inline constexpr std::uint8_t kHidToDevice = 0x21;
inline constexpr std::uint8_t kHidGetReport = 0x01;
inline constexpr std::uint8_t kHidSetReport = 0x09;

}  // namespace hedgehog::emulator
