// SPDX-License-Identifier: MIT
// A link with a board whose telemetry is set by the test.
#pragma once

#include <gtest/gtest.h>

#include "daemon/device/board_core/crc32.h"
#include "daemon/device/link.h"
#include "tests/device/limited.h"

namespace hedgehog::device {

struct LinkBench : testing::Test {
  Link link;
  LinkCommand command;
  board::TelemetryFrame board;
  LinkFrames frames;

  void telemetry() {
    ++board.sequence;
    ++board.board_ms;
    send(board);
  }
  void send(const board::TelemetryFrame& values) {
    Frame frame;
    board::write_frame(values, frame.data());
    link.receive(frame);
  }
  void send_of_another_version() {
    Frame frame;
    board::write_frame(board, frame.data());
    frame[1] = board::kProtocolVersion + 1;
    const std::uint32_t crc = board::crc32(frame.data(), 60);
    for (std::size_t i = 0; i < 4; ++i) frame[60 + i] = static_cast<std::uint8_t>(crc >> (8 * i));
    link.receive(frame);
  }
  // A new command from control, driving.
  void renew() {
    ++command.count;
    const BoardCommand before = command.board;
    command.board = BoardCommand::drive(limited({5, 0, 0}), kColdOhm, 1.5e-3, {5, 0, 0}, 12.0);
    command.board.arm_count = before.arm_count;
    command.board.boot_loader_count = before.boot_loader_count;
  }
  void step() { frames = link.step(command); }
  void tick() {
    telemetry();
    renew();
    step();
    if (frames.other) take(*frames.other);
  }
  void take(const Frame& frame) {
    board::FrameHeader header;
    ASSERT_EQ(board::read_header(frame.data(), frame.size(), header), board::FrameError::kNone);
  }
  board::SetPointFrame set_point() const { return board::read_set_point(frames.set_point.data()); }
  std::optional<std::uint8_t> arm_request() const {
    if (!frames.other) return std::nullopt;
    board::FrameHeader header;
    board::read_header(frames.other->data(), frames.other->size(), header);
    if (header.type != board::FrameType::kArm) return std::nullopt;
    return board::read_arm(frames.other->data()).count;
  }
};

}  // namespace hedgehog::device
