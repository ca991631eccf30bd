// SPDX-License-Identifier: MIT
// Ring buffer of the controller's last seconds, for the bit-exact replay of a trip.
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

/// Allocates in the constructor only. `before` and `after` around each step: control thread,
/// real-time safe; the rest: one other thread (disk). Freezes after the tick of a trip, until
/// the other thread has taken the recording.
class FlightRecorder {
 public:
  /// At least 6 s of 1 kHz with few commands; many commands shorten it.
  static constexpr std::size_t kDefaultBytes = std::size_t{5} << 18;
  static constexpr model::Tick kKeyFrameEvery = 1000;

  explicit FlightRecorder(std::size_t bytes = kDefaultBytes);

  /// Control thread.
  void before(const Controller& controller, const StepInputs& inputs) noexcept;
  void after(const Controller& controller, const device::BoardCommand& board,
             const EventList& events) noexcept;

  /// Any thread: freezes after the next recorded tick, as on a trip.
  void request() noexcept { requested_.store(true, std::memory_order_relaxed); }
  /// Disk thread: a recording is ready to be taken.
  bool frozen() const noexcept { return phase_.load(std::memory_order_acquire) == Phase::kFrozen; }
  /// Disk thread: the recording from the oldest state with all its ticks. REQUIRES: frozen().
  std::vector<std::byte> take() const;
  /// Disk thread: resumes recording at the next tick. REQUIRES: frozen().
  void resume() noexcept { phase_.store(Phase::kStarting, std::memory_order_release); }

 private:
  enum class Phase : std::uint8_t { kStarting, kRecording, kFrozen };
  static constexpr std::size_t kKeyFrames = 8;
  /// Minimum number of states in the ring: most of it can be replayed even with many commands.
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
  /// Restarted at each key frame.
  WordDelta<TickInputs> inputs_;
  WordDelta<TickOutputs> outputs_;
  std::uint64_t written_ = 0;  // bytes since the start; the ring contains the last of them
  model::Tick since_key_ = 0;
  bool recording_ = false;
  std::atomic<Phase> phase_{Phase::kStarting};
  std::atomic<bool> requested_{false};
};

}  // namespace hedgehog::control
