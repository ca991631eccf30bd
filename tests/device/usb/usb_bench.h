// SPDX-License-Identifier: MIT
// Finder and link over a simulated USB, in virtual time.
#pragma once

#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "daemon/device/board_codec.h"
#include "daemon/device/board_core/crc32.h"
#include "daemon/device/usb/board_finder.h"
#include "tests/device/usb/fake_usb.h"

namespace hedgehog::device {

using Milliseconds = BoardFinder::Milliseconds;

inline const BoardIds kAny{{{0x1209, 0x0001}}, {}};

inline std::vector<std::uint8_t> telemetry(std::uint32_t sequence, int version = 1) {
  board::TelemetryFrame values;
  values.sequence = sequence;
  Frame frame;
  board::write_frame(values, frame.data());
  frame[1] = static_cast<std::uint8_t>(version);
  const std::uint32_t crc = board::crc32(frame.data(), 60);
  for (std::size_t i = 0; i < 4; ++i) frame[60 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
  return {frame.begin(), frame.end()};
}

// Finder and link, each with its own period, on one virtual clock in milliseconds.
struct Bench {
  FakeUsb usb;
  BoardFinder finder;
  Milliseconds now{0};
  Milliseconds due{0};
  std::vector<std::vector<std::uint8_t>> received;
  int sent = 0;
  int steps = 0;

  explicit Bench(BoardIds ids = kAny) : finder(usb, std::move(ids)) {}
  ~Bench() { finder.close(); }

  void tick() {
    if (now >= due) {
      due = now + finder.step(now);
      ++steps;
    }
    std::array<std::uint8_t, 128> packet;
    while (const std::size_t length = finder.receive(packet))
      received.emplace_back(packet.begin(), packet.begin() + static_cast<long>(length));
    Frame frame{};
    if (finder.send(frame)) ++sent;
    ++now;
  }
  void run(int ms) {
    for (int i = 0; i < ms; ++i) tick();
  }
  // With a board that sends telemetry every millisecond.
  void run(FakeBoard& board, int ms, int version = 1) {
    for (int i = 0; i < ms; ++i) {
      if (board.plugged) board.packets.push_back(telemetry(++sequence, version));
      tick();
    }
  }
  // The first millisecond from now in which the board is open; nothing within a minute.
  std::optional<int> until_open() {
    for (int ms = 0; ms < 60'000; ++ms) {
      if (finder.usb_info().open) return ms;
      tick();
    }
    return std::nullopt;
  }
  const std::string& what() const { return finder.usb_info().what; }
  std::uint32_t sequence = 0;
};

inline constexpr const char* kSeven =
    "Hedgehog driver board (1209:0001), serial number 7, firmware 1.02";

}  // namespace hedgehog::device
