// SPDX-License-Identifier: MIT
// Simulation of an effect on the model of the ball as it is now: mixer, limiter and fan of the
// control thread in front of the simulator's plant.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>

#include "daemon/server/device/device_view.h"
#include "daemon/server/effects/effect_plan.h"
#include "model/tick.h"
#include "protocol/methods.h"
#include "protocol/values/effect_params.h"

namespace hedgehog::server {

/// io thread only. About 2 us a tick, so it is made in slices.
class Preview {
 public:
  /// Of all connections together; each has one at most.
  static constexpr std::size_t kMaxAtOnce = 4;
  /// Ticks that io can spare at a time.
  static constexpr model::Tick kSlice = 250;
  /// Of one preview: no effect is longer, and a lease runs out once.
  static constexpr model::Tick kMaxSlices =
      std::max(protocol::kMaxDurationMs, protocol::kMaxLeaseMs) / kSlice;

  /// As if `plan` began now on an armed ball whose sensors are sane, nobody else played, the ball
  /// lay still, and a lease ran out once. `plan` and `device_view` are not needed afterwards.
  Preview(const DeviceView& device_view, const EffectPlan& plan);
  ~Preview();
  Preview(const Preview&) = delete;
  Preview& operator=(const Preview&) = delete;

  /// `ticks` more, at most to the end. True: done.
  bool advance(model::Tick ticks);
  /// REQUIRES: done.
  protocol::PreviewResult result() const;

 private:
  struct World;
  void step();

  std::unique_ptr<World> world_;
};

}  // namespace hedgehog::server
