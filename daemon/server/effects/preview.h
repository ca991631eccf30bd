// SPDX-License-Identifier: MIT
// Simulation of an effect on the model of the ball in its present state: mixer, limiter and fan of
// the control thread with the simulator's plant.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "daemon/server/device/device_view.h"
#include "daemon/server/effects/planning.h"
#include "model/tick.h"
#include "protocol/methods.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::server {

/// io thread only. About 2 us per tick, so it is computed in slices.
class Preview {
 public:
  static constexpr std::size_t kMaxAtOnce = 4;  // in total; each connection has one at most
  static constexpr model::Tick kSlice = 250;    // per slice on the io thread
  /// Maximum for one preview: that of the longest effect or a single lease.
  static constexpr model::Tick kMaxSlices =
      std::max(protocol::kMaxDurationMs, protocol::kMaxLeaseMs) / kSlice;

  /// Assumes that `plan` starts now on an armed ball with valid sensors, without other effects, at
  /// rest, and that a lease expires once. `plan` and `device_view` are not used afterwards.
  Preview(const DeviceView& device_view, const EffectPlan& plan);
  ~Preview();
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// Simulates at most `ticks` more. True: done.
  bool advance(model::Tick ticks);
  protocol::PreviewResult result() const;  // REQUIRES: done

 private:
  struct World;
  void step();

  std::unique_ptr<World> world_;
};

}  // namespace hedgehog::server
