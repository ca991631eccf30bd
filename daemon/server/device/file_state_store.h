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
  bool r25_changed() const noexcept;  // of a winding, from the saved one
  class File;
  /// Passes `saved_` to the disk thread, replacing a pending state; false: its queue is full.
  bool submit_write();
  void write();
  /// Compares the board with the saved one each time that it is detected.
  void identify_ball();

  DiskThread& disk_;
  std::shared_ptr<File> file_;  // shared with the disk thread
  DeviceView& device_view_;
  SavedState saved_;
  std::array<R25History, model::kCoils> r25_before_{};  // from before this run
  std::chrono::steady_clock::time_point written_{};
  std::uint64_t submitted_ = 0;  // number of the last state passed to the disk thread
  bool due_ = false;
  bool was_warm_ = false;
  bool stopped_ = false;
  bool identified_ = false;       // the present board has been compared
  bool thermistor_seen_ = false;  // since the start; until then the last run's temperatures hold
  control::Reason requested_latch_ = control::Reason::kNone;  // not yet in a snapshot
  model::Tick requested_tick_ = 0;
};

}  // namespace hedgehog::server
