// SPDX-License-Identifier: MIT
// Slices of a sound are scheduled by the current device time, even if older telemetry is still
// unread.
#include "clients/ctl/verbs/sound_player.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "tests/clients/fake_daemon.h"
#include "tests/clients/wav_sample.h"
#include "tests/temporary_folder.h"

namespace hedgehog::client {
namespace {

using nlohmann::json;

constexpr std::int64_t kNsPerS = 1'000'000'000;

/// A daemon whose time stands still until it has a number of effects. Then it advances by half a
/// minute, as for a stopped program (Ctrl-Z), while older telemetry is still unread.
class ScriptedDaemon {
 public:
  explicit ScriptedDaemon(std::size_t effects) : effects_(effects) {}

  /// Ends early when there are more than `effects`.
  void run(FakePeer& peer) {
    for (std::string line = peer.read(); !line.empty(); line = peer.read()) {
      const json request = json::parse(line);
      const std::size_t before = starts_ns_.size();
      peer.send_line(
          json{{"jsonrpc", "2.0"}, {"id", request["id"]}, {"result", result(request)}}.dump());
      if (starts_ns_.size() > effects_) return;
      if (starts_ns_.size() == before || starts_ns_.size() != effects_) continue;
      time_ns_ = 30 * kNsPerS;
      std::string lines = message("telemetry", {{"time_ns", 2 * kNsPerS / 5}});
      for (std::size_t effect = 1; effect <= effects_; ++effect)
        lines += message("event", {{"type", "effect_ended"},
                                   {"time_ns", 3 * kNsPerS},
                                   {"effect", effect},
                                   {"reason", "completed"}});
      peer.send(lines);
    }
  }
  const std::vector<std::int64_t>& starts_ns() const { return starts_ns_; }

 private:
  static std::string message(const char* method, const json& params) {
    return json{{"jsonrpc", "2.0"}, {"method", method}, {"params", params}}.dump() + "\n";
  }
  json result(const json& request) {
    if (request["method"] == "ping") return {{"time_ns", time_ns_}};
    if (request["method"] == "events.subscribe")
      return {{"state", "armed"}, {"reason", nullptr}, {"derating", false}, {"limit_a", 15}};
    if (request["method"] == "telemetry.subscribe")
      return {{"rate_hz", 20}, {"fields", json::array({"time_ns"})}};
    starts_ns_.push_back(request["params"]["start_at_ns"]);
    return {{"effect", starts_ns_.size()},
            {"accepted", true},
            {"limited_by", nullptr},
            {"current_a", 5},
            {"force_n", 1},
            {"pin", 1},
            {"headroom_s", nullptr},
            {"seq", 1}};
  }

  std::size_t effects_;
  std::int64_t time_ns_ = 0;
  std::vector<std::int64_t> starts_ns_{};
};

TEST(SoundPlayer, SkipsSlicesMissedWhileStopped) {
  // Of six half-second slices, four begin within the two seconds that are sent ahead.
  ScriptedDaemon paused(4);
  FakeDaemon daemon([&](FakePeer& peer) { paused.run(peer); });
  const TemporaryFolder folder;
  const auto tone = [](double t) { return std::pair(0.5 * sine(t, 40.0), 0.0); };
  sound::SliceOptions options;
  options.pulses = 0.0;
  PlayableSound sound{
      sound::SliceReader(
          sound::SoundFile::open(folder.write("tone.wav", wav_of(3.0, tone))).value(), options),
      "{}", "{}"};
  {
    Session session{Connection::open({daemon.address()}, kLongTimeout).value(), true, {}};
    SoundPlayer player(session, sound, "tone");
    const auto played = player.play();
    EXPECT_TRUE(played) << played.error().message;
    EXPECT_FALSE(player.all_completed());
  }
  daemon.finish();
  const std::vector<std::int64_t> in_time{3 * kNsPerS / 10, 8 * kNsPerS / 10, 13 * kNsPerS / 10,
                                          18 * kNsPerS / 10};
  EXPECT_EQ(paused.starts_ns(), in_time);
}

}  // namespace
}  // namespace hedgehog::client
