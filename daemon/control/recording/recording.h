// SPDX-License-Identifier: MIT
// The last seconds of the controller as bytes: its state at one tick, then the inputs (what changed
// of TickInputs, the stops, the commands) and what changed of the outputs of each tick from there.
// Only the program that wrote them can replay them, so they carry its build id.
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

/// Identifies this very program: its linker's build id in hex, else its version.
std::string build_id();

/// Header and state of a recording; records are appended to it.
std::vector<std::byte> begin_recording(const Controller& start);
/// Ends it with a CRC-32 of everything before, so that no damaged byte is ever replayed.
void end_recording(std::vector<std::byte>& recording);

enum class ReplayError : std::uint8_t {
  kNone,
  kUnreadable,     // no such file, or it cannot be read
  kNotARecording,  // not ours, or damaged
  kOtherBuild,     // written by another build; install that version to replay it
};

/// One replayed tick, for the sink. `controller` is valid during the call.
struct ReplayedTick {
  const StepInputs& inputs;
  const TickOutputs& recorded;
  const TickOutputs& replayed;
  const EventList& events;
  const Controller& controller;
  /// The outputs agree bit for bit.
  bool same = false;
};

struct ReplayResult {
  ReplayError error = ReplayError::kNone;
  std::uint64_t ticks = 0;
  std::uint64_t different = 0;
  /// The build that wrote the recording; known unless it is not one.
  std::string written_by;
};

using ReplaySink = std::function<void(const ReplayedTick&)>;

/// Runs the recorded ticks through a controller once more. Any thread; may take as long as it
/// takes.
ReplayResult replay(std::span<const std::byte> recording, const ReplaySink& sink);
/// The same from a file (`hedgehogd --replay F`).
ReplayResult replay_recording(const std::string& path, const ReplaySink& sink);

}  // namespace hedgehog::control
