// SPDX-License-Identifier: MIT
#include "daemon/server/device/file_state_store.h"

#include <spdlog/spdlog.h>
#include <unistd.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>

#include "base/atomic_file.h"
#include "daemon/server/disk/load_saved_state.h"
#include "model/thermal/thermal_flow.h"

namespace hedgehog::server {
namespace {

constexpr std::chrono::seconds kPeriod{1};
/// A ball this much above ambient is warm enough for its temperatures to be saved.
constexpr double kWarmK = 2.0;
/// After this time the snapshot contains every latch reported by an event or a request.
constexpr model::Tick kLatchSeen = 200;

constexpr const char* kCountsAsCrash = "; the next start is treated as one after a crash";

bool finite(const model::ThermalState& heat) {
  return std::isfinite(heat.core_c) && std::isfinite(model::hottest_winding(heat));
}

}  // namespace

/// Written by the disk thread only, before that by the creating thread.
class FileStateStore::File {
 public:
  /// `orderly`: the present file records an orderly stop.
  File(std::string path, bool orderly) : path_(std::move(path)), orderly_(orderly) {}

  /// Replaces the file. If a state without an orderly stop cannot be written, a file that records
  /// an orderly stop is removed, because the next start would arm the ball in spite of a latched
  /// stop. Removing works on a full disk.
  void write(const SavedState& state, bool last) {
    const std::string problem = base::write_file_atomically(path_, encode(state));
    if (problem.empty()) {
      orderly_ = state.clean_stop;
      failed_ = false;
      return;
    }
    if (orderly_ && !state.clean_stop) {
      std::error_code ec;
      std::filesystem::remove(path_, ec);
      orderly_ = ec || !base::sync_folder(std::filesystem::path(path_).parent_path()).empty();
    }
    if (!failed_.exchange(true) || last) {  // one line an episode
      spdlog::error("{}: the state was not saved{}", problem,
                    orderly_ ? "; remove the old file by hand before the next start, which would "
                               "use it"
                    : last   ? kCountsAsCrash
                             : "");
    }
  }
  /// The last write failed. Any thread.
  bool failed() const noexcept { return failed_; }

  /// Number of the newest state whose write was attempted, and of the newest on disk. Any thread.
  std::uint64_t attempted() const noexcept { return attempted_; }
  std::uint64_t on_disk() const noexcept { return on_disk_; }

  /// Sets the state to write next, and its number; false: one is already pending.
  bool put(const SavedState& state, std::uint64_t number, bool last) {
    const std::lock_guard lock(mutex_);
    last_ = last_ || last;
    number_ = number;
    return !std::exchange(next_, state).has_value();
  }
  void drop() {
    const std::lock_guard lock(mutex_);
    next_.reset();
  }
  void write_next() {
    std::optional<SavedState> state;
    std::uint64_t number = 0;
    bool last = false;
    {
      const std::lock_guard lock(mutex_);
      state.swap(next_);
      number = number_;
      last = last_;
    }
    if (!state) return;
    write(*state, last);
    if (!failed_) on_disk_ = number;
    attempted_ = number;
  }

 private:
  const std::string path_;
  bool orderly_;
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::optional<SavedState> next_;
  std::uint64_t number_ = 0;
  bool last_ = false;
  std::atomic<std::uint64_t> attempted_{0};
  std::atomic<std::uint64_t> on_disk_{0};
};

FileStateStore::FileStateStore(const std::string& directory, DiskThread& disk,
                               DeviceView& device_view, const std::optional<SavedState>& last)
    : disk_(disk),
      file_(std::make_shared<File>(state_file(directory), last && last->clean_stop)),
      device_view_(device_view),
      saved_(last.value_or(SavedState{})) {
  // Until the next orderly stop this run counts as aborted.
  saved_.clean_stop = false;
  r25_before_ = saved_.r25;
  std::array<double, model::kCoils> kept{};
  for (std::size_t i = 0; i < kept.size(); ++i) kept[i] = saved_.r25[i].ohm;
  device_view_.set_saved_r25(kept);
  if (!saved_.ball) saved_.ball = ball_of(device_view.config());
  if (last) file_->write(saved_, false);
  // An incomplete file is useless beside a complete one.
  const std::string path = state_file(directory);
  std::error_code ignored;
  if (std::filesystem::is_regular_file(path, ignored)) ::unlink((path + ".new").c_str());
}

SavedState FileStateStore::current() const {
  const control::StatusSnapshot& now = device_view_.now();
  SavedState state = saved_;
  state.latch = now.latch != control::Reason::kNone ? now.latch : requested_latch_;
  state.clean_stop = stopped_ && state.latch == control::Reason::kNone;
  if (now.tick > 0) state.rearms = now.rearms;
  for (std::size_t i = 0; i < state.r25.size(); ++i)
    if (now.r25_ohm[i] > 0.0) state.r25[i] = {now.r25_ohm[i], r25_before_[i].runs + 1};
  if (!thermistor_seen_) return state;
  if (finite(now.thermal.nodes) && std::isfinite(now.thermal.ambient_c)) {
    state.heat_known = true;
    state.measured = now.thermal.measured;
    state.saved_at = boot_time_now();
    state.heat = now.thermal.nodes;
    state.ambient_c = now.thermal.ambient_c;
  }
  return state;
}

bool FileStateStore::r25_changed() const noexcept {
  for (std::size_t i = 0; i < saved_.r25.size(); ++i) {
    const double ohm = device_view_.now().r25_ohm[i];
    if (ohm > 0.0 && ohm != saved_.r25[i].ohm) return true;
  }
  return false;
}

void FileStateStore::identify_ball() {
  if (!device_view_.now().board_present) identified_ = false;
  if (identified_ || !device_view_.now().board_present) return;
  const BallIdentity seen{device_view_.simulated(), device_view_.board().serial.value_or("")};
  if (are_different(*saved_.ball, seen)) {
    if (!device_view_.outbox().add(0, control::ResetBall{})) return;
    device_view_.outbox().commit();
    spdlog::error("the ball was replaced: serial number {}, before {}{}", seen.serial,
                  saved_.ball->serial, kCountsAsTripped);
    saved_.heat_known = false;
    saved_.r25 = r25_before_ = {};
    device_view_.set_saved_r25({});
    thermistor_seen_ = false;
  }
  identified_ = seen.simulated || !seen.serial.empty();
  if (!seen.serial.empty() && seen.serial != saved_.ball->serial) {
    saved_.ball = seen;
    due_ = true;
  }
}

void FileStateStore::pump(std::chrono::steady_clock::time_point time) {
  const control::StatusSnapshot& now = device_view_.now();
  if (now.tick <= 0) return;  // no snapshot of the control thread yet
  identify_ball();
  thermistor_seen_ = thermistor_seen_ || (now.board_present && now.sensor_valid);
  due_ = due_ || r25_changed();
  if (requested_latch_ != control::Reason::kNone && now.tick >= requested_tick_ + kLatchSeen) {
    requested_latch_ = control::Reason::kNone;
    due_ = true;
  }
  const bool warm =
      model::hottest_winding(now.thermal.nodes) > now.thermal.ambient_c + kWarmK || was_warm_;
  if (!due_ && !((warm || file_->failed()) && time - written_ >= kPeriod)) return;
  was_warm_ = model::hottest_winding(now.thermal.nodes) > now.thermal.ambient_c + kWarmK;
  written_ = time;
  due_ = false;
  write();
}

void FileStateStore::state_changed(control::State state) noexcept {
  due_ = true;
  if (state == control::State::kArmed) requested_latch_ = control::Reason::kNone;
}

bool FileStateStore::submit_write() {
  if (!file_->put(saved_, ++submitted_, stopped_)) return true;
  const bool taken = disk_.post(DiskUse::kSafety, [file = file_] { file->write_next(); });
  if (!taken) file_->drop();
  return taken;
}

void FileStateStore::write() {
  saved_ = current();
  due_ = !submit_write() || due_;
}

void FileStateStore::stopped_cleanly() {
  stopped_ = true;
  saved_ = current();
  // Queued after pending writes, so that no older state is written after it.
  if (!submit_write())
    spdlog::error("the disk is too slow: the state was not saved{}", kCountsAsCrash);
}

void FileStateStore::persist_gain(double gain) {
  saved_.gain = gain;
  due_ = true;
}

std::uint64_t FileStateStore::persist_latch(control::Reason latch) {
  requested_latch_ = latch;
  requested_tick_ = device_view_.now().tick;
  write();
  return submitted_;
}

Persisted FileStateStore::latch_persisted(std::uint64_t write) const {
  if (file_->on_disk() >= write) return Persisted::kYes;
  return file_->attempted() >= write ? Persisted::kNo : Persisted::kPending;
}

}  // namespace hedgehog::server
