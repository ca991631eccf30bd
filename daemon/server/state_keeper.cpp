// SPDX-License-Identifier: MIT
#include "daemon/server/state_keeper.h"

#include <spdlog/spdlog.h>

#include <atomic>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <mutex>
#include <system_error>
#include <utility>

#include "model/thermal_flow.h"

namespace hedgehog::server {
namespace {

constexpr const char* kFile = "state.json";
constexpr std::chrono::seconds kPeriod{1};
/// A ball this much above its room has heat worth remembering.
constexpr double kWarmK = 2.0;
/// By then the snapshot has every latch that an event or a request has told of.
constexpr model::Tick kLatchSeen = 200;

constexpr const char* kAsAfterACrash = "; the next start counts as one after a crash";

bool finite(const model::ThermalState& heat) {
  return std::isfinite(heat.core_c) && std::isfinite(model::hottest_winding(heat));
}

std::string path_in(const std::string& directory) {
  return (std::filesystem::path(directory) / kFile).string();
}

}  // namespace

/// Only the disk thread writes, and who makes it before that.
class StateKeeper::File {
 public:
  /// `orderly`: what is there tells of an orderly stop.
  File(std::string path, bool orderly) : path_(std::move(path)), orderly_(orderly) {}

  /// In place of what was there. A file that tells of an orderly stop does not outlive a state that
  /// is none and cannot be written: the ball would be armed after a stop that was forgotten. A full
  /// disk still removes.
  void write(const SavedState& state, bool last) {
    const std::string problem = write_file_atomically(path_, encode(state));
    if (problem.empty()) {
      orderly_ = state.clean_stop;
      failed_ = false;
      return;
    }
    if (orderly_ && !state.clean_stop) {
      std::error_code ec;
      std::filesystem::remove(path_, ec);
      orderly_ = ec || !sync_folder(std::filesystem::path(path_).parent_path()).empty();
    }
    if (!failed_.exchange(true) || last) {  // one line an episode
      spdlog::error("{}: the state is not kept{}{}", problem, last ? kAsAfterACrash : "",
                    orderly_ ? ", but for the old file, which must be removed by hand" : "");
    }
  }
  /// The last write did. Any thread.
  bool failed() const noexcept { return failed_; }

  /// What is written next; false: something waits for that already.
  bool put(const SavedState& state, bool last) {
    const std::lock_guard lock(mutex_);
    last_ = last_ || last;
    return !std::exchange(next_, state).has_value();
  }
  void drop() {
    const std::lock_guard lock(mutex_);
    next_.reset();
  }
  void write_next() {
    std::optional<SavedState> state;
    bool last = false;
    {
      const std::lock_guard lock(mutex_);
      state.swap(next_);
      last = last_;
    }
    if (state) {
      write(*state, last);
    }
  }

 private:
  const std::string path_;
  bool orderly_;
  std::atomic<bool> failed_{false};
  std::mutex mutex_;
  std::optional<SavedState> next_;
  bool last_ = false;
};

double wall_time_s() {
  using Seconds = std::chrono::duration<double>;
  return Seconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

std::optional<SavedState> load_saved_state(const std::string& directory) {
  const std::string path = path_in(directory);
  std::ifstream file(path, std::ios::binary);
  if (!file) {
    return std::nullopt;
  }
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto state = decode_saved_state(text);
  if (!state) {
    spdlog::warn("{}: damaged; the ball counts as never measured", path);
  }
  return state.value_or(SavedState{});
}

StateKeeper::StateKeeper(const std::string& directory, DiskThread& disk, const Machine& machine,
                         const std::optional<SavedState>& last)
    : disk_(disk),
      file_(std::make_shared<File>(path_in(directory), last && last->clean_stop)),
      machine_(machine),
      saved_(last.value_or(SavedState{})) {
  // Until the next orderly stop this run counts as one that was cut off.
  saved_.clean_stop = false;
  if (last) {
    file_->write(saved_, false);
  }
}

SavedState StateKeeper::current() const {
  const control::StatusSnapshot& now = machine_.now();
  SavedState state = saved_;
  state.latch = now.latch != control::Reason::kNone ? now.latch : asked_latch_;
  state.clean_stop = stopped_ && state.latch == control::Reason::kNone;
  if (!thermistor_seen_) {
    return state;
  }
  if (finite(now.thermal.nodes) && std::isfinite(now.thermal.room_c)) {
    state.heat_known = true;
    state.measured = now.thermal.measured;
    state.wall_time_s = wall_time_s();
    state.heat = now.thermal.nodes;
    state.room_c = now.thermal.room_c;
  }
  return state;
}

void StateKeeper::pump(std::chrono::steady_clock::time_point time) {
  const control::StatusSnapshot& now = machine_.now();
  if (now.tick <= 0) {
    return;  // the control thread has said nothing yet
  }
  thermistor_seen_ = thermistor_seen_ || (now.board_present && now.sensor_valid);
  if (asked_latch_ != control::Reason::kNone && now.tick >= asked_at_ + kLatchSeen) {
    asked_latch_ = control::Reason::kNone;
    due_ = true;
  }
  const bool warm =
      model::hottest_winding(now.thermal.nodes) > now.thermal.room_c + kWarmK || was_warm_;
  if (!due_ && !((warm || file_->failed()) && time - written_ >= kPeriod)) {
    return;
  }
  was_warm_ = model::hottest_winding(now.thermal.nodes) > now.thermal.room_c + kWarmK;
  written_ = time;
  due_ = false;
  write();
}

void StateKeeper::state_changed(control::State state) noexcept {
  due_ = true;
  if (state == control::State::kArmed) {
    asked_latch_ = control::Reason::kNone;
  }
}

bool StateKeeper::hand_over() {
  if (!file_->put(saved_, stopped_)) {
    return true;
  }
  const bool taken = disk_.post(DiskUse::kSafety, [file = file_] { file->write_next(); });
  if (!taken) {
    file_->drop();
  }
  return taken;
}

void StateKeeper::write() {
  saved_ = current();
  due_ = !hand_over() || due_;
}

void StateKeeper::stopped_cleanly() {
  stopped_ = true;
  saved_ = current();
  // Behind what still waits, so that nothing older is written after it.
  if (!hand_over()) {
    spdlog::error("the disk is too slow: the state is not kept{}", kAsAfterACrash);
  }
}

void StateKeeper::remember_gain(double gain) {
  saved_.gain = gain;
  due_ = true;
}

void StateKeeper::remember_latch(control::Reason latch) {
  asked_latch_ = latch;
  asked_at_ = machine_.now().tick;
  write();
}

}  // namespace hedgehog::server
