// SPDX-License-Identifier: MIT
#include "daemon/server/state_keeper.h"

#include <spdlog/spdlog.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
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

double wall_time_s() {
  using Seconds = std::chrono::duration<double>;
  return Seconds(std::chrono::system_clock::now().time_since_epoch()).count();
}

bool finite(const model::ThermalState& heat) {
  return std::isfinite(heat.core_c) && std::isfinite(model::hottest_winding(heat));
}

}  // namespace

std::optional<SavedState> load_saved_state(const std::string& directory) {
  const std::string path = (std::filesystem::path(directory) / kFile).string();
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
    : path_((std::filesystem::path(directory) / kFile).string()),
      disk_(disk),
      machine_(machine),
      saved_(last.value_or(SavedState{})) {
  // Until the next orderly stop this run counts as one that was cut off.
  saved_.clean_stop = false;
  if (last) {
    const std::string problem = write_file_atomically(path_, encode(saved_));
    if (!problem.empty()) {
      spdlog::error("{}: the state is not kept", problem);
    }
  }
}

SavedState StateKeeper::current() const {
  const control::StatusSnapshot& now = machine_.now();
  SavedState state = saved_;
  state.latch = now.latch != control::Reason::kNone ? now.latch : asked_latch_;
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

void StateKeeper::pump() {
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
  const auto time = std::chrono::steady_clock::now();
  if (!due_ && !(warm && time - written_ >= kPeriod)) {
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
  return disk_.post([path = path_, text = encode(saved_)] {
    static bool failing = false;  // disk thread only; one line an episode
    const std::string problem = write_file_atomically(path, text);
    if (!problem.empty() && !failing) {
      spdlog::error("{}: the state is not kept", problem);
    }
    failing = !problem.empty();
  });
}

void StateKeeper::write() {
  saved_ = current();
  due_ = !hand_over() || due_;
}

void StateKeeper::stopped_cleanly() {
  saved_ = current();
  saved_.clean_stop = saved_.latch == control::Reason::kNone;
  // Behind what still waits, so that nothing older is written after it or at the same time.
  if (!hand_over()) {
    write_file_atomically(path_, encode(saved_));
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
