// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/simulated_board_transport.h"

#include <algorithm>

namespace hedgehog::device {
namespace {

constexpr std::int64_t kMillisecondNs = 1'000'000;
/// Half a period from the link's ticks, so that with jitter exactly one millisecond is due at each
/// tick.
constexpr std::int64_t kPhaseNs = kLinkPhaseNs + kMillisecondNs / 2;

}  // namespace

SimulatedBoardTransport::SimulatedBoardTransport(const SimulatedBoardOptions& options,
                                                 Clock now_ns) noexcept
    : board_(options),
      now_ns_(now_ns),
      next_ns_(at_phase_before(now_ns(), kPhaseNs) + kMillisecondNs) {}

bool SimulatedBoardTransport::send(
    std::span<const std::uint8_t, board::kFrameSize> frame) noexcept {
  board_.receive(frame);
  return true;
}

std::size_t SimulatedBoardTransport::receive(std::span<std::uint8_t> packet) noexcept {
  if (delivered_ == queued_) run_due_steps();
  if (delivered_ == queued_) return 0;
  const Frame& frame = frames_[delivered_++];
  const std::size_t length = std::min(frame.size(), packet.size());
  std::copy_n(frame.begin(), length, packet.begin());
  return length;
}

void SimulatedBoardTransport::run_due_steps() noexcept {
  queued_ = delivered_ = 0;
  const std::int64_t late_ns = now_ns_() - next_ns_;
  if (late_ns < 0) return;
  const std::int64_t due = late_ns / kMillisecondNs + 1;
  next_ns_ += due * kMillisecondNs;
  for (std::int64_t i = 0; i < std::min(due, kMaxSteps); ++i) {
    keep(board_.step());
    keep(board_.truth_frame());
  }
}

void SimulatedBoardTransport::keep(const std::optional<Frame>& frame) noexcept {
  if (frame) frames_[queued_++] = *frame;
}

}  // namespace hedgehog::device
