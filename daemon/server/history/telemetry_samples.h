// SPDX-License-Identifier: MIT
// The last ten minutes of telemetry, one sample per second, for newly opened pages. Bounded and
// allocated once; filled by the io thread from the control thread's status.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/control/snapshot.h"
#include "model/tick.h"
#include "protocol/methods/telemetry.h"
#include "protocol/values/status.h"

namespace hedgehog::server {

/// io thread only.
class TelemetrySamples {
 public:
  static constexpr std::size_t kMaxSamples = 600;
  static constexpr model::Tick kPeriod = 1000;  // covered by one sample

  TelemetrySamples() { samples_.reserve(kMaxSamples); }

  /// Called with every snapshot: keeps the largest current.
  void watch(const control::StatusSnapshot& now) noexcept;
  /// A sample is complete with this snapshot.
  bool due(model::Tick now) const noexcept { return now - last_tick_ >= kPeriod; }
  /// Adds that sample. `status`: of the snapshot `now`.
  void add(const control::StatusSnapshot& now, const protocol::Status& status);

  /// The last `seconds`, with several samples combined if they exceed the size of a response.
  protocol::TelemetryHistoryResult recent(double seconds, model::Tick now,
                                          std::int64_t time_ns) const;

  /// Conversion to and from the file: a stop is a gap of the duration given by the time of day.
  /// Damaged data, and that of another version or from the future, is ignored.
  std::string encoded(model::Tick now, std::int64_t unix_ms) const;
  void restore(std::string_view bytes, model::Tick now, std::int64_t unix_ms);
  /// A current was measured since the last `saved`.
  bool changed() const noexcept { return changed_; }
  void saved() noexcept { changed_ = false; }

 private:
  /// NaN: unknown. Written to disk as is.
  struct Sample {
    model::Tick tick = 0;
    std::array<float, 3> coils_c{};
    float upper_c = 0.0F;
    float sensor_c = 0.0F;
    float current_a = 0.0F;
    float peak_a = 0.0F;
    float limit_a = 0.0F;
    std::array<float, 3> duty{};
    float headroom_s = 0.0F;
  };
  struct FileHead;

  const Sample& at(std::size_t age) const noexcept;
  void push(const Sample& sample);
  static protocol::TelemetrySample merged(const std::vector<Sample>& samples, model::Tick now);

  std::vector<Sample> samples_;  // a ring buffer
  std::size_t next_ = 0;         // the oldest, once it is full
  control::Totals totals_{};
  model::Tick last_tick_ = 0;
  double peak_a_ = 0.0;
  bool changed_ = false;
};

}  // namespace hedgehog::server
