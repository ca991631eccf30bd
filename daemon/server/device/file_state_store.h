// SPDX-License-Identifier: MIT
// Persists `state.json`: every second while the ball is warm, and at once on a latch or a change of
// the owner's gain. Detects a replaced ball. A failed write is repeated each second; meanwhile no
// file on disk records an orderly stop.
#pragma once

#include <chrono>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>

#include "daemon/server/device/device_view.h"
#include "daemon/server/device/state_store.h"
#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/disk/saved_state.h"

namespace hedgehog::server {

/// io thread only; the disk thread writes.
class FileStateStore final : public StateStore {
 public:
  /// `last`: the state loaded at the start.
  FileStateStore(const std::string& directory, DiskThread& disk, DeviceView& device_view,
                 const std::optional<SavedState>& last);

  /// After every pump.
  void pump(std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  void state_changed(control::State state) noexcept;
  /// Writes the final state; it is on disk, or the failure is logged, at the latest when the disk
  /// thread has ended. REQUIRES: the control loop has stopped.
  void stopped_cleanly();

  void persist_gain(double gain) override;
  std::uint64_t persist_latch(control::Reason latch) override;
  Persisted latch_persisted(std::uint64_t write) const override;

 private:
  SavedState current() const;
  /// R25 of a winding differs from the saved one.
  bool r25_changed() const noexcept;
  class File;
  /// Passes `saved_` to the disk thread, replacing a pending state; false: its queue is full.
  bool submit_write();
  void write();
  /// Compares the board with the saved one each time that it is detected.
  void identify_ball();

  DiskThread& disk_;
  /// Shared with the disk thread.
  std::shared_ptr<File> file_;
  DeviceView& device_view_;
  SavedState saved_;
  /// Values from before this run.
  std::array<R25History, model::kCoils> r25_before_{};
  std::chrono::steady_clock::time_point written_{};
  /// Number of the last state passed to the disk thread.
  std::uint64_t submitted_ = 0;
  bool due_ = false;
  bool was_warm_ = false;
  bool stopped_ = false;
  /// The present board has been compared.
  bool identified_ = false;
  /// Seen since the start; before it the temperatures of the last run are the best estimate.
  bool thermistor_seen_ = false;
  /// Requested, not yet contained in a snapshot.
  control::Reason requested_latch_ = control::Reason::kNone;
  model::Tick requested_tick_ = 0;
};

}  // namespace hedgehog::server
