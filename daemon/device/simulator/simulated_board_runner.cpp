// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/simulated_board_runner.h"

#include <array>
#include <utility>

#include "daemon/device/tick_clock.h"
#include "daemon/device/transport.h"

namespace hedgehog::device {
SimulatedBoardRunner::SimulatedBoardRunner(const SimulatedBoardOptions& options,
                                           std::unique_ptr<Transport> transport,
                                           std::FILE* trace) noexcept
    : board_(options), transport_(std::move(transport)), trace_(trace) {}

void SimulatedBoardRunner::run(const std::atomic<bool>& stop) noexcept {
  use_fifo(kSimulatedBoardPriority);
  trace_.note(board_, "start");
  TickClock clock;
  bool host_gone = false;
  for (int shutdown_ms = kShutdownMs; shutdown_ms > 0 && !stop.load(std::memory_order_relaxed);) {
    clock.wait();
    tick();
    if (!host_gone && !transport_->open()) {
      host_gone = true;
      trace_.note(board_, "closed");
    }
    if (host_gone) --shutdown_ms;
    if (host_gone && at_rest()) break;
  }
  trace_.note(board_, "exit");
}

void SimulatedBoardRunner::run_in_step(const SocketTransport& socket) noexcept {
  std::array<std::uint8_t, 2 * board::kFrameSize> packet;
  for (std::uint32_t now_ms = 1; transport_->open();) {
    constexpr int kNoTimeout = -1;
    socket.wait(kNoTimeout);
    const std::size_t length = transport_->receive(packet);
    if (length == 0) continue;
    const auto received = std::span(packet).first(length);
    board_.receive(received);
    board::FrameHeader header;
    if (board::read_header(packet.data(), length, header) != board::FrameError::kNone ||
        header.type != board::FrameType::kSetPoint)
      continue;
    if (const std::optional<Frame> telemetry = board_.step()) transport_->send(*telemetry);
    transport_->send(board_.truth(now_ms++));
    trace_.after_step(board_);
  }
}

void SimulatedBoardRunner::tick() noexcept {
  std::array<std::uint8_t, 2 * board::kFrameSize> packet;
  for (int i = 0; i < kMaxPacketsPerTick && transport_->open(); ++i) {
    const std::size_t length = transport_->receive(packet);
    if (length == 0) break;
    board_.receive(std::span(packet).first(length));
  }
  if (const std::optional<Frame> telemetry = board_.step()) transport_->send(*telemetry);
  if (const std::optional<Frame> truth = board_.truth_frame()) transport_->send(*truth);
  trace_.after_step(board_);
}

bool SimulatedBoardRunner::at_rest() const noexcept {
  const board::Mode mode = board_.core().mode();
  return (mode == board::Mode::kSafe || mode == board::Mode::kLatched) &&
         norm(board_.plant().current_a()) < SimulatedBoardTrace::kZeroA;
}

}  // namespace hedgehog::device
