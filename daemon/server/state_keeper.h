// SPDX-License-Identifier: MIT
// Keeps `state.json` true: every second while the ball is warm, and at once when something latches
// or the owner changes the gain. What the disk refuses is tried again each second; meanwhile no
// file stands there that tells of an orderly stop.
#pragma once

#include <chrono>
#include <memory>
#include <optional>
#include <string>

#include "daemon/server/disk_thread.h"
#include "daemon/server/machine.h"
#include "daemon/server/saved_state.h"
#include "daemon/server/services.h"

namespace hedgehog::server {

/// Seconds since 1970 by the clock on the wall, which people may set.
double wall_time_s();

/// The state file in `directory`; nullopt: there is none. One that is damaged or impossible counts
/// as heat not known. Start-up only.
std::optional<SavedState> load_saved_state(const std::string& directory);

/// io thread only; the writing is done by the disk thread.
class StateKeeper final : public Memory {
 public:
  /// `last`: as loaded at the start.
  StateKeeper(const std::string& directory, DiskThread& disk, const Machine& machine,
              const std::optional<SavedState>& last);

  /// After every pump.
  void pump(std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  void state_changed(control::State state) noexcept;
  /// The last word; on disk, or the log says why not, at the latest when the disk thread has ended.
  /// REQUIRES: the control loop has stopped.
  void stopped_cleanly();

  void remember_gain(double gain) override;
  void remember_latch(control::Reason latch) override;

 private:
  SavedState current() const;
  class File;
  /// `saved_`, to the disk thread, in place of what it has not begun to write; false: it has no
  /// room.
  bool hand_over();
  void write();

  DiskThread& disk_;
  /// With the disk thread.
  std::shared_ptr<File> file_;
  const Machine& machine_;
  SavedState saved_;
  std::chrono::steady_clock::time_point written_{};
  bool due_ = false;
  bool was_warm_ = false;
  bool stopped_ = false;
  /// Since the start; before it the heat of the last run is the best there is.
  bool thermistor_seen_ = false;
  /// Asked for, not yet seen in a snapshot.
  control::Reason asked_latch_ = control::Reason::kNone;
  model::Tick asked_at_ = 0;
};

}  // namespace hedgehog::server
