// SPDX-License-Identifier: MIT
// The only connection between io and the control thread: a queue for commands, a stop board that
// bypasses it, the latest status, and a queue of events.
#pragma once

#include <array>
#include <atomic>
#include <boost/lockfree/spsc_queue.hpp>
#include <cstdint>

#include "base/triple_buffer.h"
#include "daemon/control/effects/command.h"
#include "daemon/control/effects/effect_times.h"
#include "daemon/control/event_signal.h"
#include "daemon/control/snapshot.h"
#include "daemon/control/state/event.h"
#include "daemon/control/step_inputs.h"
#include "daemon/device/orientation.h"
#include "daemon/device/thermometer/sample.h"

namespace hedgehog::control {

/// Times at which io read the request of a command and queued it, by its seq: for the metrics only,
/// so that commands (and recordings of them) need not contain them.
class RequestTimes {
 public:
  /// io thread.
  void received(std::uint64_t seq, std::int64_t ns) noexcept {
    times_[seq % kRemembered].received_ns.store(ns, std::memory_order_relaxed);
  }
  void queued(std::uint64_t seq, std::int64_t ns) noexcept {
    times_[seq % kRemembered].queued_ns.store(ns, std::memory_order_relaxed);
  }
  /// Control thread, real-time safe. 0: unknown. REQUIRES: the command has come through the queue.
  EffectTimes of(std::uint64_t seq) const noexcept {
    const Times& times = times_[seq % kRemembered];
    return {seq, times.received_ns.load(std::memory_order_relaxed),
            times.queued_ns.load(std::memory_order_relaxed)};
  }

 private:
  struct Times {
    std::atomic<std::int64_t> received_ns{0};
    std::atomic<std::int64_t> queued_ns{0};
  };
  /// Exceeds the number of commands in transit.
  static constexpr std::size_t kRemembered = 2048;
  std::array<Times, kRemembered> times_{};
};

/// Stop requests, one word per effect place: overwritten, never full, read at the next tick.
class StopBoard {
 public:
  /// io thread. Ends `effect` in `place`, even if its start is still queued.
  void request(EffectId effect, std::uint8_t place, EndReason reason) noexcept {
    words_[place].store(effect | (static_cast<std::uint64_t>(reason) << 32),
                        std::memory_order_release);
    changed_[place / 64].fetch_or(std::uint64_t{1} << (place % 64), std::memory_order_acq_rel);
  }

  /// Control thread, real-time safe: copies the requests since the last call to `inputs`.
  void collect(StepInputs& inputs) noexcept {
    inputs.stop_count = 0;
    for (int half = 0; half < 2; ++half) {
      std::uint64_t mask = changed_[half].exchange(0, std::memory_order_acq_rel);
      for (; mask != 0; mask &= mask - 1) {
        const auto place = static_cast<std::uint8_t>(half * 64 + __builtin_ctzll(mask));
        const std::uint64_t word = words_[place].load(std::memory_order_acquire);
        inputs.stops[inputs.stop_count++] = {static_cast<EffectId>(word), place,
                                             static_cast<EndReason>(word >> 32)};
      }
    }
  }

 private:
  std::array<std::atomic<std::uint64_t>, kEffectPlaces> words_{};
  std::array<std::atomic<std::uint64_t>, 2> changed_{};
};

static_assert(kEffectPlaces == 128, "StopBoard keeps its change flags in two words");

struct Mailbox {
  static constexpr std::size_t kCommands = 512;
  static constexpr std::size_t kEvents = 8192;
  /// Exceeds what io leaves unread for long; further ones are not measured.
  static constexpr std::size_t kEffectTimes = 1024;

  /// io -> control. `push` fails when full: respond with `busy`, never wait.
  boost::lockfree::spsc_queue<Command, boost::lockfree::capacity<kCommands>> commands;
  RequestTimes request_times;
  StopBoard stops;
  /// io -> control: incremented by device.emergency_stop.
  std::atomic<std::uint32_t> emergency_generation{0};
  /// Orientation sensor thread (or io, for `external` and the simulator) -> control.
  base::TripleBuffer<device::OrientationSample> orientation;
  /// Second thermometer's thread -> control.
  base::TripleBuffer<device::ThermometerSample> thermometer;

  /// control -> io.
  boost::lockfree::spsc_queue<Event, boost::lockfree::capacity<kEvents>> events;
  boost::lockfree::spsc_queue<EffectTimes, boost::lockfree::capacity<kEffectTimes>> effect_times;
  base::TripleBuffer<StatusSnapshot> status;
  /// Raised by control when `events` got some, after `status` was written; by io when a client
  /// begins to wait for a tick, so that it does not wait for the end of a pause.
  EventSignal wake_io;
};

}  // namespace hedgehog::control
