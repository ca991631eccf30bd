// SPDX-License-Identifier: MIT
#include "daemon/server/disk/load_saved_state.h"

#include <spdlog/spdlog.h>

#include <filesystem>
#include <system_error>

#include "base/regular_file.h"

namespace hedgehog::server {
namespace {

/// Exceeds the size of any state by far.
constexpr std::size_t kMaxBytes = std::size_t{64} << 10;

}  // namespace

std::string state_file(const std::string& directory) {
  return (std::filesystem::path(directory) / "state.json").string();
}

BallIdentity ball_of(const config::Config& config) {
  if (config.backend == config::Backend::kSimulator) return {true, ""};
  return {false, config.device.usb_serial};
}

std::optional<SavedState> load_saved_state(const std::string& directory,
                                           const std::optional<BallIdentity>& ball) {
  const auto lost = [](const std::string& path, const std::string& why) {
    spdlog::error("{}: {}{}", path, why, kCountsAsTripped);
    return lost_state();
  };
  const std::string path = state_file(directory);
  const auto is_missing = [](const std::string& file) {
    std::error_code ec;
    return std::filesystem::symlink_status(file, ec).type() ==
           std::filesystem::file_type::not_found;
  };
  if (is_missing(path)) {
    if (is_missing(path + ".new")) return std::nullopt;
    return lost(path, "missing beside a state.json.new that was cut off");
  }
  const base::FileText file = base::read_regular_file(path, kMaxBytes);
  if (!file.good()) return lost(path, file.problem);
  auto state = decode_saved_state(file.text);
  if (!state) return lost(path, "damaged");
  if (ball && state->ball && are_different(*ball, *state->ball)) {
    if (ball->simulated) {
      spdlog::warn("{}: of a real ball; the simulated one starts without it", path);
      return std::nullopt;
    }
    return lost(path, state->ball->simulated
                          ? "of a simulated ball"
                          : "of the ball " + state->ball->serial + ", and this is " + ball->serial);
  }
  if (state->latch != control::Reason::kNone)
    spdlog::warn("the last run ended with a latch: {}", control::name(state->latch));
  return state;
}

}  // namespace hedgehog::server
