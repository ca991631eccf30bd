// SPDX-License-Identifier: MIT
// The ball's effects while a program plays on it, as reported to another client of the daemon.
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
  std::string ended;       // the reason; empty: it is still playing
  double flowed_ms = 0;    // in device time, set when it has ended
  double peak_a = 0;       // largest current measured meanwhile, over all windings
  double field_a = 0;      // largest current measured in a tick with a field
  model::Vec3 side{};      // direction of the field at that time
  model::Vec3 begun_at{};  // direction of the field at the first measured current
};

/// Subscribes to the events of all clients and to telemetry. One thread.
class BallLog {
 public:
  /// `socket`: path of the daemon's socket.
  explicit BallLog(const std::string& socket);

  /// Reads until `done`; false after a minute.
  bool until(const std::function<bool()>& done);
  /// Reads until `count` effects have ended since the last `clear`.
  bool until_ended(std::size_t count);
  /// Reads until an effect plays with the field on `side` and at least `current_a`.
  bool until_pushed(const model::Vec3& side, double current_a);
  /// Reads until no current flows.
  bool until_still();

  /// In the order of their starts; a replacement in the same slot is a separate effect.
  const std::vector<PlayedEffect>& played() const noexcept { return played_; }
  std::size_t ended() const;
  model::Vec3 side() const noexcept { return side_; }
  /// The latest measurement.
  double current_a() const noexcept { return current_a_; }
  void clear() { played_.clear(); }
  /// Readable text: a line for each effect.
  std::string text() const;

 private:
  void read();
  void handle_event(const e2e::Json& event);
  void handle_telemetry(const e2e::Json& telemetry);
  PlayedEffect* find(std::int64_t effect);

  e2e::RawClient client_;
  std::vector<PlayedEffect> played_;
  model::Vec3 side_{};
  double current_a_ = 0;
};

}  // namespace hedgehog::vm
