// SPDX-License-Identifier: MIT
// The driver board with the firmware's own image, emulated by another process in lock-step: its
// descriptors, responses and stalls are those of the image.
#pragma once

#include <chrono>
#include <cstdint>
#include <cstdio>
#include <deque>
#include <memory>
#include <string>

#include "emulator/emulated_device.h"
#include "emulator/firmware/board_link.h"

namespace hedgehog::emulator {

class FirmwareBoard final : public EmulatedDevice {
 public:
  /// Reads the board's descriptors. `trace`: a file for its events; empty: none. Throws
  /// std::runtime_error, and std::system_error when the trace cannot be written.
  FirmwareBoard(std::unique_ptr<BytePort> port, const std::string& trace);

  Exported exported() const override { return exported_; }
  std::string product_name() const override { return product_name_; }
  std::string serial() const override { return serial_; }

  /// The board's time begins when it is plugged in for the first time; afterwards the
  /// simulated ball runs on without a host.
  void step() override;
  /// {"board_us", "awake", "closed", "set_point_age_us", "current_a", "peak_a", "frames_in",
  ///  "frames_out", "bus_errors", "exchange_us", "max_exchange_us"}: the true currents; peak_a is
  /// the largest norm since the previous status; bus_errors are violations of USB by the firmware;
  /// exchange_us is the mean time that a millisecond of the board has taken on this machine's
  /// clock.
  std::string status() const override;

  void plugged() override;
  void unplugged() override;
  std::optional<Bytes> control(const SetupPacket& setup, std::span<const Byte> data) override;
  bool accepts(std::uint8_t endpoint) const override;
  void out(std::uint8_t endpoint, std::span<const Byte> data) override;
  std::optional<Bytes> take(std::uint8_t endpoint) override;
  void set_pending_reads(std::uint8_t endpoint, std::size_t count) override;
  /// By a request to the firmware, whose halt ends when it is cleared once. Throws
  /// std::runtime_error for another number of times, and when the firmware rejects it.
  void halt(std::uint8_t address, int times) override;
  bool halted(std::uint8_t address) const override;

 private:
  struct Close {
    void operator()(std::FILE* file) const noexcept { std::fclose(file); }
  };
  Bytes descriptor(std::uint8_t type, std::uint8_t index);
  std::string string_descriptor(std::uint8_t index);
  void read_descriptors();
  void clear();

  std::unique_ptr<std::FILE, Close> file_;
  std::unique_ptr<BoardLink> link_;
  Exported exported_;
  std::string product_name_;
  std::string serial_;

  bool started_ = false;
  bool in_halted_ = false;
  bool out_halted_ = false;
  /// Packets that the process has not received yet, and how many it has that the board has not
  /// accepted.
  std::deque<Bytes> out_;
  std::size_t queued_ = 0;
  std::deque<Bytes> in_;
  std::size_t pending_reads_ = 0;

  std::uint64_t exchanges_ = 0;
  std::chrono::steady_clock::duration exchange_sum_{};
  std::chrono::steady_clock::duration max_exchange_{};
};

}  // namespace hedgehog::emulator
