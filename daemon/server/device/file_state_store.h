// SPDX-License-Identifier: MIT
// Persists `state.json`: every second while the ball is warm, and at once when something latches or
// the owner changes the gain. Detects that another ball was plugged in. A failed write is repeated
// each second; meanwhile no file on disk claims an orderly stop.
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

/// io thread only; the writing is done by the disk thread.
class FileStateStore final : public StateStore {
 public:
  /// `last`: as loaded at the start.
  FileStateStore(const std::string& directory, DiskThread& disk, DeviceView& device_view,
                 const std::optional<SavedState>& last);

  /// After every pump.
  void pump(std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  void state_changed(control::State state) noexcept;
  /// The last word; on disk, or the log says why not, at the latest when the disk thread has ended.
  /// REQUIRES: the control loop has stopped.
  void stopped_cleanly();

  void persist_gain(double gain) override;
  std::uint64_t persist_latch(control::Reason latch) override;
  Persisted latch_persisted(std::uint64_t write) const override;

 private:
  SavedState current() const;
  /// R25 of a winding is another one than was kept.
  bool r25_changed() const noexcept;
  class File;
  /// `saved_`, to the disk thread, in place of what it has not begun to write; false: it has no
  /// room.
  bool hand_over();
  void write();
  /// Compares the board with the saved one each time that it appears.
  void recognise_ball();

  DiskThread& disk_;
  /// With the disk thread.
  std::shared_ptr<File> file_;
  DeviceView& device_view_;
  SavedState saved_;
  /// As before this run.
  std::array<R25History, model::kCoils> r25_before_{};
  std::chrono::steady_clock::time_point written_{};
  /// Counts what was handed over, and which of that had the last latch first.
  std::uint64_t handed_over_ = 0;
  bool due_ = false;
  bool was_warm_ = false;
  bool stopped_ = false;
  /// The board that is there now has been compared.
  bool recognised_ = false;
  /// Since the start; before it the heat of the last run is the best there is.
  bool thermistor_seen_ = false;
  /// Asked for, not yet seen in a snapshot.
  control::Reason asked_latch_ = control::Reason::kNone;
  model::Tick asked_at_ = 0;
};

}  // namespace hedgehog::server
