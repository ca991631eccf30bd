// SPDX-License-Identifier: MIT
#include "daemon/device/simulated_board_runner.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <utility>

#include "daemon/device/tick_clock.h"

namespace hedgehog::device {
namespace {

// More than the host sends in a millisecond, and all that a socket holds after a pause.
constexpr int kPacketsPerTick = 512;

const char* name_of(board::Mode mode) noexcept {
  switch (mode) {
    case board::Mode::kSafe:
      return "safe";
    case board::Mode::kReady:
      return "ready";
    case board::Mode::kDriving:
      return "driving";
    case board::Mode::kLatched:
      return "latched";
  }
  return "latched";
}

}  // namespace

SimulatedBoardRunner::SimulatedBoardRunner(const SimulatedBoardOptions& options,
                                           std::unique_ptr<Transport> transport,
                                           std::FILE* trace) noexcept
    : board_(options), transport_(std::move(transport)), trace_(trace) {}

void SimulatedBoardRunner::run(const std::atomic<bool>& stop) noexcept {
  use_fifo(kSimulatedBoardPriority);
  note("start");
  TickClock clock;
  bool host_gone = false;
  for (int farewell_ms = kFarewellMs; farewell_ms > 0 && !stop.load(std::memory_order_relaxed);) {
    clock.wait();
    tick();
    if (!host_gone && !transport_->open()) {
      host_gone = true;
      note("closed");
    }
    if (host_gone) --farewell_ms;
    if (host_gone && at_rest()) break;
  }
  note("exit");
}

void SimulatedBoardRunner::tick() noexcept {
  std::array<std::uint8_t, 2 * board::kFrameSize> packet;
  for (int i = 0; i < kPacketsPerTick && transport_->open(); ++i) {
    const std::size_t length = transport_->receive(packet);
    if (length == 0) break;
    board_.receive(std::span(packet).first(length));
  }
  if (const std::optional<Frame> telemetry = board_.step()) transport_->send(*telemetry);

  if (board_.core().mode() != traced_mode_) {
    traced_mode_ = board_.core().mode();
    note("mode");
  }
  const bool flows = norm(board_.plant().current_a()) >= kZeroA;
  if (current_flowed_ && !flows && !board_.core().outputs().awake) note("zero");
  current_flowed_ = flows;
}

bool SimulatedBoardRunner::at_rest() const noexcept {
  const board::Mode mode = board_.core().mode();
  return (mode == board::Mode::kSafe || mode == board::Mode::kLatched) &&
         norm(board_.plant().current_a()) < kZeroA;
}

void SimulatedBoardRunner::note(const char* event) noexcept {
  if (trace_ == nullptr) return;
  const board::BoardCore& core = board_.core();
  std::array<char, 16> age{"null"};
  if (core.set_point_age_ms() != UINT32_MAX)
    std::snprintf(age.data(), age.size(), "%u", core.set_point_age_ms());
  int duty = 0;
  for (const std::int16_t one : core.outputs().duty_q15) duty = std::max(duty, std::abs(one));
  std::fprintf(trace_,
               "{\"event\": \"%s\", \"board_ms\": %u, \"set_point_age_ms\": %s, \"mode\": \"%s\", "
               "\"faults\": %u, \"awake\": %s, \"duty\": %.4f, \"current_a\": %.4f}\n",
               event, core.now_ms(), age.data(), name_of(core.mode()),
               static_cast<unsigned>(core.faults()), core.outputs().awake ? "true" : "false",
               duty / kFullDuty, norm(board_.plant().current_a()));
  std::fflush(trace_);
}

SimulatedBoardThread::SimulatedBoardThread(const SimulatedBoardOptions& options,
                                           std::unique_ptr<Transport> transport)
    : runner_(options, std::move(transport)) {
  const SignalsBlocked blocked;
  thread_ = std::thread([this] { runner_.run(stop_); });
}

SimulatedBoardThread::~SimulatedBoardThread() {
  stop_.store(true, std::memory_order_relaxed);
  thread_.join();
}

}  // namespace hedgehog::device
