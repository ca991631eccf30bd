// SPDX-License-Identifier: MIT
// Ring buffer of the controller's last seconds, so that a trip can be replayed bit for bit.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "daemon/control/controller.h"
#include "daemon/control/recording/tick_outputs.h"
#include "daemon/control/recording/word_delta.h"
#include "daemon/control/state/event_list.h"
#include "daemon/control/step_inputs.h"

namespace hedgehog::control {

/// All memory is taken in the constructor. The control thread calls `before` and `after` around
/// each step, both real-time safe; one other thread (disk) calls the rest. When a ball trips the
/// recorder freezes after that tick, until the other thread has taken the recording.
class FlightRecorder {
 public:
  /// Room for at least 6 s of 1 kHz with few commands; a flood of commands shortens it.
  static constexpr std::size_t kDefaultBytes = std::size_t{5} << 18;
  static constexpr model::Tick kKeyFrameEvery = 1000;

  explicit FlightRecorder(std::size_t bytes = kDefaultBytes);

  /// Control thread.
  void before(const Controller& controller, const StepInputs& inputs) noexcept;
  void after(const Controller& controller, const device::BoardCommand& board,
             const EventList& events) noexcept;

  /// Any thread: freeze after the next tick that is recorded, as if it had tripped.
  void request() noexcept { requested_.store(true, std::memory_order_relaxed); }
  /// Disk thread: the recording waits to be taken.
  bool frozen() const noexcept { return phase_.load(std::memory_order_acquire) == Phase::kFrozen; }
  /// Disk thread: the recording as bytes, from the oldest state whose ticks are all still there.
  /// REQUIRES: frozen().
  std::vector<std::byte> take() const;
  /// Disk thread: records again, from the next tick on. REQUIRES: frozen().
  void resume() noexcept { phase_.store(Phase::kStarting, std::memory_order_release); }

 private:
  enum class Phase : std::uint8_t { kStarting, kRecording, kFrozen };
  static constexpr std::size_t kKeyFrames = 8;
  /// At least so many states within the ring, so that even a flood leaves most of it to be
  /// replayed.
  static constexpr std::size_t kKeyFramesARing = 4;
  struct KeyFrame {
    bool used = false;
    std::uint64_t position = 0;
  };

  void write(const void* from, std::size_t bytes) noexcept;
  template <class T>
  void write_delta(WordDelta<T>& delta, const T& value) noexcept;
  void key_frame(const Controller& controller) noexcept;
  bool intact(const KeyFrame& frame) const noexcept;

  std::vector<std::byte> ring_;
  std::vector<Controller> states_;
  std::array<KeyFrame, kKeyFrames> frames_{};
  std::size_t next_frame_ = 0;
  /// Each key frame begins them anew.
  WordDelta<TickInputs> inputs_;
  WordDelta<TickOutputs> outputs_;
  /// Bytes written since the start; the ring has the last of them.
  std::uint64_t written_ = 0;
  model::Tick since_key_ = 0;
  bool recording_ = false;
  std::atomic<Phase> phase_{Phase::kStarting};
  std::atomic<bool> requested_{false};
};

}  // namespace hedgehog::control
