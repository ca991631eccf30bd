// SPDX-License-Identifier: MIT
#include "daemon/device/link_thread.h"

#include <array>
#include <utility>

#include "daemon/device/tick_clock.h"

namespace hedgehog::device {
namespace {

// More than a socket can hold after a pause, so that no old telemetry is left behind.
constexpr int kPacketsPerTick = 512;

}  // namespace

LinkThread::LinkThread(LinkPort& port, std::unique_ptr<Transport> transport,
                       const std::optional<BoardLimits>& limits)
    : port_(port), transport_(std::move(transport)), link_(limits ? Link(*limits) : Link()) {
  const SignalsBlocked blocked;
  thread_ = std::thread([this] { run(); });
}

LinkThread::~LinkThread() {
  stop_.store(true, std::memory_order_relaxed);
  thread_.join();
}

void LinkThread::run() noexcept {
  real_time_.store(use_fifo(kLinkPriority), std::memory_order_relaxed);
  TickClock clock;
  while (!stop_.load(std::memory_order_relaxed)) {
    skipped_.fetch_add(clock.wait(), std::memory_order_relaxed);
    tick();
  }
  LinkCommand last = port_.commands.read();
  last.board = BoardCommand{};
  ++last.count;
  transport_->send(link_.step(last).set_point);
}

void LinkThread::tick() noexcept {
  std::array<std::uint8_t, 2 * board::kFrameSize> packet;
  for (int i = 0; i < kPacketsPerTick; ++i) {
    const std::size_t length = transport_->receive(packet);
    if (length == 0) break;
    link_.receive(std::span(packet).first(length));
  }
  const BoardLimits& limits = port_.limits.read();
  if (port_.limits.was_fresh()) link_.set_limits(limits);
  const LinkCommand& command = port_.commands.read();
  const SimulatorSettings& simulator = port_.simulator.read();
  simulator_known_ = simulator_known_ || port_.simulator.was_fresh();
  const LinkFrames frames = simulator_known_ ? link_.step(command, simulator) : link_.step(command);
  transport_->send(frames.set_point);
  if (frames.other) transport_->send(*frames.other);
  port_.reports.write(link_.report());
}

}  // namespace hedgehog::device
