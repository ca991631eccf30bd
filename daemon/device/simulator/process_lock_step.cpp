// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/process_lock_step.h"

#include <array>

#include "daemon/device/board_codec.h"
#include "daemon/device/tick_clock.h"
#include "daemon/device/transport.h"

namespace hedgehog::device {

void ProcessLockStep::step() noexcept {
  const LinkFrames frames = link_.step(port_);
  if (socket_) exchange(frames);
  port_.reports.write(link_.report());
  if (link_.truth().known) port_.truth.write(link_.truth());
}

void ProcessLockStep::exchange(const LinkFrames& frames) noexcept {
  const bool sent = socket_->send(frames.set_point);
  if (sent) link_.set_written(monotonic_ns());
  // The set-point starts the board's millisecond; this frame applies to the next one.
  if (frames.other) socket_->send(*frames.other);
  // Repeating the wait in each following step would block the daemon for hours.
  if (sent && !receive_until_truth()) socket_.reset();
}

bool ProcessLockStep::receive_until_truth() noexcept {
  std::array<std::uint8_t, 2 * board::kFrameSize> packet;
  for (int i = 0; i < kMaxPacketsPerTick && socket_->open(); ++i) {
    socket_->wait(max_wait_ms_);
    const std::size_t length = socket_->receive(packet);
    if (length == 0) return false;
    const auto received = std::span(packet).first(length);
    link_.receive(received);
    if (decode_truth(received)) return true;
  }
  return socket_->open();
}

}  // namespace hedgehog::device
