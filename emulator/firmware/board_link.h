// SPDX-License-Identifier: MIT
// Requests to the process of an emulated board, in lock-step with it: README.md.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "emulator/emulated_device.h"
#include "emulator/firmware/byte_port.h"

namespace hedgehog::emulator {

/// The emulator's thread, which waits in each request. Each throws std::runtime_error when the
/// process does not respond, reports an error, or responds with something else.
class BoardLink {
 public:
  explicit BoardLink(std::unique_ptr<BytePort> port) : port_(std::move(port)) {}

  /// Connects the bus: supply, reset, address.
  void plug() { request(Type::kPlug, {}); }
  void unplug() { request(Type::kUnplug, {}); }
  /// A control transfer; nullopt: stalled, or not answered.
  std::optional<Bytes> control(const SetupPacket& setup, std::span<const Byte> data);

  struct Millisecond {
    bool in_halted = false;
    bool out_halted = false;
    /// OUT packets that the board has not accepted yet.
    std::size_t queued = 0;
    std::vector<Bytes> in;
    /// Lines of JSON (tests/firmware/emulated/board_trace.mjs).
    std::string events;
  };
  /// Runs the board until one more millisecond has passed since `plug`. `out`: further packets for
  /// endpoint 1; `reads`: at most so many packets of endpoint 1 are read.
  Millisecond run(std::span<const Bytes> out, std::size_t reads);
  /// One JSON object on one line.
  std::string status();

  static constexpr std::size_t kMaxPacket = 64;
  static constexpr std::size_t kMaxPackets = 16;

 private:
  enum class Type : Byte { kPlug = 1, kUnplug = 2, kControl = 3, kRun = 4, kStatus = 5 };
  Bytes request(Type type, std::span<const Byte> payload);
  /// Exactly `length` bytes.
  Bytes receive(std::size_t length);

  std::unique_ptr<BytePort> port_;
};

}  // namespace hedgehog::emulator
