// SPDX-License-Identifier: MIT
// The driver board: the board core and the simulated ball, connected by real frames on two bulk
// endpoints.
#pragma once

#include <cstdio>
#include <memory>

#include "daemon/device/simulator/simulated_board.h"
#include "daemon/device/simulator/simulated_board_trace.h"
#include "emulator/gadget.h"

namespace hedgehog::emulator {

inline constexpr std::uint16_t kBoardVendor = 0x1209;
inline constexpr std::uint16_t kBoardProduct = 0x0001;
inline constexpr std::uint8_t kBoardClass = 0xFF;
inline constexpr std::uint8_t kBoardSubclass = 0x48;
inline constexpr std::uint8_t kBoardProtocol = 0x01;

struct BoardSettings {
  std::string serial = "B1";
  device::SimulatedBoardOptions board;
  /// Trace file; empty: none.
  std::string trace;
};

class BoardGadget : public Gadget {
 public:
  /// Throws std::system_error when the trace cannot be written.
  explicit BoardGadget(const BoardSettings& settings);

  void step() override;
  std::optional<std::string> command(std::span<const std::string> words) override;
  /// {"board_ms", "mode", "faults", "set_point_age_ms", "awake", "current_a", "peak_a",
  ///  "frames_in", "frames_out", "frames_lost"}: the true currents; peak_a is the largest norm
  /// since the previous status; frames_lost were not read by the host in time.
  std::string status() const override;

 protected:
  void handle_out(std::uint8_t endpoint, std::span<const Byte> data) override;

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> file_;
  device::SimulatedBoard board_;
  device::SimulatedBoardTrace trace_;
  std::uint8_t version_ = board::kProtocolVersion;
  std::uint64_t frames_in_ = 0;
  std::uint64_t frames_out_ = 0;
  mutable double peak_a_ = 0.0;
};

/// A different device with the ids of a board, which are public test ids.
class OtherDeviceGadget : public Gadget {
 public:
  explicit OtherDeviceGadget(const std::string& serial);
  void step() override {}
  std::string status() const override { return "{}"; }

 protected:
  void handle_out(std::uint8_t /*endpoint*/, std::span<const Byte> /*data*/) override {}
};

}  // namespace hedgehog::emulator
