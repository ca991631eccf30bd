// SPDX-License-Identifier: MIT
// The last seconds of the controller as bytes: its state at one tick, then for each following tick
// the inputs (changed words of TickInputs, the stops, the commands) and the changed words of the
// outputs. Only the program that wrote them can replay them, so they contain its build id.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "daemon/control/controller.h"
#include "daemon/control/recording/tick_outputs.h"
#include "daemon/control/step_inputs.h"

namespace hedgehog::control {

/// Identifies the build of this program: the linker's build id in hex, else its version.
std::string build_id();

/// Header and state of a recording, to which records are appended.
std::vector<std::byte> begin_recording(const Controller& start);
/// Appends a CRC-32 of everything before, so that a damaged recording is never replayed.
void end_recording(std::vector<std::byte>& recording);

enum class ReplayError : std::uint8_t {
  kNone,
  kUnreadable,     // the file does not exist or cannot be read
  kNotARecording,  // another format, or damaged
  kOtherBuild,     // written by another build; install that version to replay it
};

/// One replayed tick, for the sink. `controller` is valid during the call.
struct ReplayedTick {
  const StepInputs& inputs;
  const TickOutputs& recorded;
  const TickOutputs& replayed;
  const EventList& events;
  const Controller& controller;
  bool same = false;  // the outputs agree bit for bit
};

struct ReplayResult {
  ReplayError error = ReplayError::kNone;
  std::uint64_t ticks = 0;
  std::uint64_t different = 0;
  std::string written_by;  // build id of the writing program; empty without a valid header
};

using ReplaySink = std::function<void(const ReplayedTick&)>;

/// Runs the recorded ticks through a controller once more. Any thread; run time not bounded.
ReplayResult replay(std::span<const std::byte> recording, const ReplaySink& sink);
/// The same from a file (`hedgehogd --replay F`).
ReplayResult replay_recording(const std::string& path, const ReplaySink& sink);

}  // namespace hedgehog::control
