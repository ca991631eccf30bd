// SPDX-License-Identifier: MIT
// What the ball does while a program plays on it, as another client of the daemon sees it.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "model/vec3.h"
#include "tests/e2e/raw_client.h"

namespace hedgehog::vm {

/// One effect, from its start to its end.
struct PlayedEffect {
  std::int64_t effect = 0;
  std::string slot;
  std::string method;
  std::string ended;       // the reason; empty: it plays
  double flowed_ms = 0;    // of device time, when it has ended
  double peak_a = 0;       // the largest current measured meanwhile, of all windings
  model::Vec3 side{};      // where the field pointed then
  model::Vec3 begun_at{};  // where it pointed when a current was measured first
};

/// Subscribes to the events of all clients and to telemetry. One thread.
class BallLog {
 public:
  /// `socket`: the daemon's.
  explicit BallLog(const std::string& socket);

  /// Reads on until `done`; false after a minute without.
  bool until(const std::function<bool()>& done);
  /// Reads on until `count` effects have ended since the last `clear`.
  bool until_ended(std::size_t count);
  /// Reads on until an effect plays with the field on `side` and at least `current_a`.
  bool until_pushed(const model::Vec3& side, double current_a);
  /// Reads on until no current flows.
  bool until_still();

  /// In the order of their starts; a replacement in the same slot is an effect of its own.
  const std::vector<PlayedEffect>& played() const noexcept { return played_; }
  std::size_t ended() const;
  model::Vec3 side() const noexcept { return side_; }
  /// As last measured.
  double current_a() const noexcept { return current_a_; }
  void clear() { played_.clear(); }
  /// For a person: a line for each effect.
  std::string text() const;

 private:
  void read();
  void take_event(const e2e::Json& event);
  void take_telemetry(const e2e::Json& telemetry);
  PlayedEffect* find(std::int64_t effect);

  e2e::RawClient client_;
  std::vector<PlayedEffect> played_;
  model::Vec3 side_{};
  double current_a_ = 0;
};

}  // namespace hedgehog::vm
