// SPDX-License-Identifier: MIT
// A USB device emulated in this process: descriptors, control requests on endpoint 0, and packets
// of its other endpoints. Transport: HostSession.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "emulator/emulated_device.h"

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

/// The emulator's thread.
class Gadget : public EmulatedDevice {
 public:
  explicit Gadget(GadgetShape shape) : shape_(std::move(shape)) {}

  const GadgetShape& shape() const noexcept { return shape_; }
  Exported exported() const override;
  std::string product_name() const override { return shape_.name; }
  std::string serial() const override { return shape_.serial; }

  /// Resets queues and halts.
  void plugged() override;
  std::optional<Bytes> control(const SetupPacket& setup, std::span<const Byte> data) override;
  void out(std::uint8_t endpoint, std::span<const Byte> data) override;
  std::optional<Bytes> take(std::uint8_t endpoint) override;
  void halt(std::uint8_t address, int times) override { halts_[address] = times; }
  bool halted(std::uint8_t address) const override;

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
  std::uint64_t lost_ = 0;
};

/// Requests of HID devices.
inline constexpr std::uint8_t kHidToHost = 0xA1;
inline constexpr std::uint8_t kHidToDevice = 0x21;
inline constexpr std::uint8_t kHidGetReport = 0x01;
inline constexpr std::uint8_t kHidSetReport = 0x09;

}  // namespace hedgehog::emulator
