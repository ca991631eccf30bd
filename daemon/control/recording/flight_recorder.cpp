// SPDX-License-Identifier: MIT
#include "daemon/control/recording/flight_recorder.h"

#include <algorithm>
#include <cstring>

#include "daemon/control/recording/recording.h"

namespace hedgehog::control {

FlightRecorder::FlightRecorder(std::size_t bytes)
    : ring_(bytes), states_(kKeyFrames, Controller(ControlSettings{})) {}

void FlightRecorder::write(const void* from, std::size_t bytes) noexcept {
  const auto* source = static_cast<const std::byte*>(from);
  const std::size_t at = static_cast<std::size_t>(written_ % ring_.size());
  const std::size_t first = std::min(bytes, ring_.size() - at);
  if (first > 0) std::memcpy(ring_.data() + at, source, first);
  if (bytes > first) std::memcpy(ring_.data(), source + first, bytes - first);
  written_ += bytes;
}

template <class T>
void FlightRecorder::write_delta(WordDelta<T>& delta, const T& value) noexcept {
  std::array<std::byte, WordDelta<T>::kMaxBytes> bytes;
  write(bytes.data(), delta.encode(value, bytes));
}

void FlightRecorder::key_frame(const Controller& controller) noexcept {
  states_[next_frame_] = controller;
  frames_[next_frame_] = {true, written_};
  next_frame_ = (next_frame_ + 1) % kKeyFrames;
  since_key_ = 0;
  inputs_.restart();
  outputs_.restart();
}

void FlightRecorder::before(const Controller& controller, const StepInputs& inputs) noexcept {
  const Phase phase = phase_.load(std::memory_order_acquire);
  recording_ = phase != Phase::kFrozen;
  if (!recording_) return;
  if (phase == Phase::kStarting) {
    frames_ = {};
    written_ = 0;
    since_key_ = kKeyFrameEvery;
    phase_.store(Phase::kRecording, std::memory_order_relaxed);
  }
  const KeyFrame& newest = frames_[(next_frame_ + kKeyFrames - 1) % kKeyFrames];
  if (since_key_ >= kKeyFrameEvery || written_ - newest.position >= ring_.size() / kKeyFramesARing)
    key_frame(controller);
  ++since_key_;
  write_delta<TickInputs>(inputs_, inputs);
  write(inputs.stops.data(), sizeof(StopRequest) * inputs.stop_count);
  write(inputs.commands.data(), sizeof(Command) * inputs.command_count);
}

void FlightRecorder::after(const Controller& controller, const device::BoardCommand& board,
                           const EventList& events) noexcept {
  const bool tripped =
      std::any_of(events.begin(), events.end(), [](const Event& event) { return event.trip; });
  if (!recording_) return;
  const bool freeze = requested_.exchange(false, std::memory_order_relaxed) || tripped;
  write_delta(outputs_, outputs_of(controller, board, events));
  if (freeze) phase_.store(Phase::kFrozen, std::memory_order_release);
}

bool FlightRecorder::intact(const KeyFrame& frame) const noexcept {
  return frame.used && written_ - frame.position <= ring_.size();
}

std::vector<std::byte> FlightRecorder::take() const {
  const KeyFrame* oldest = nullptr;
  std::size_t index = 0;
  for (std::size_t i = 0; i < kKeyFrames; ++i) {
    const KeyFrame& frame = frames_[i];
    if (intact(frame) && (oldest == nullptr || frame.position < oldest->position)) {
      oldest = &frame;
      index = i;
    }
  }
  if (oldest == nullptr) return {};
  std::vector<std::byte> bytes = begin_recording(states_[index]);
  const std::size_t length = static_cast<std::size_t>(written_ - oldest->position);
  const std::size_t start = static_cast<std::size_t>(oldest->position % ring_.size());
  const std::size_t first = std::min(length, ring_.size() - start);
  const auto begin = ring_.begin() + static_cast<std::ptrdiff_t>(start);
  bytes.insert(bytes.end(), begin, begin + static_cast<std::ptrdiff_t>(first));
  bytes.insert(bytes.end(), ring_.begin(),
               ring_.begin() + static_cast<std::ptrdiff_t>(length - first));
  end_recording(bytes);
  return bytes;
}

}  // namespace hedgehog::control
