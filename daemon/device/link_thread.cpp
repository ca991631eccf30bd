// SPDX-License-Identifier: MIT
#include "daemon/device/link_thread.h"

#include <array>
#include <utility>

#include "daemon/device/tick_clock.h"
#include "daemon/device/transport.h"

namespace hedgehog::device {
namespace {

// Milliseconds between two polls without a board.
constexpr int kIdleTicks = 10;

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
  use_fifo(kLinkPriority);
  TickClock clock = TickClock::at_phase(kLinkPhaseNs);
  while (!stop_.load(std::memory_order_relaxed)) {
    const bool idle = transport_->idle() && !link_.report().present;
    const int wanted = idle ? kIdleTicks : 1;
    const std::uint64_t late = clock.wait(wanted);
    link_.skip(late + static_cast<std::uint64_t>(wanted - 1));
    tick();
  }
  LinkCommand last = port_.commands.read();
  last.board = BoardCommand{};
  ++last.count;
  transport_->send(link_.step(last).set_point);
}

void LinkThread::tick() noexcept {
  std::array<std::uint8_t, 2 * board::kFrameSize> packet;
  for (int i = 0; i < kMaxPacketsPerTick; ++i) {
    const std::size_t length = transport_->receive(packet);
    if (length == 0) break;
    link_.receive(std::span(packet).first(length));
  }
  const LinkFrames frames = link_.step(port_);
  if (transport_->send(frames.set_point)) link_.set_written(monotonic_ns());
  if (frames.other) transport_->send(*frames.other);
  port_.reports.write(link_.report());
  if (link_.truth().known) port_.truth.write(link_.truth());
}

}  // namespace hedgehog::device
