// SPDX-License-Identifier: MIT
// Exclusive lease on the device (`device.claim`).
#pragma once

#include "daemon/server/session/session.h"
#include "model/tick.h"

namespace hedgehog::server {

/// io thread only. The lease counts device time.
class Claim {
 public:
  /// Another client holds it at `now`.
  bool excludes(ConnectionId id, model::Tick now) const noexcept {
    return holder(now) != 0 && holder(now) != id;
  }
  /// 0: none.
  ConnectionId holder(model::Tick now) const noexcept { return now < until_ ? holder_ : 0; }
  model::Tick remaining(model::Tick now) const noexcept { return now < until_ ? until_ - now : 0; }

  /// Takes or renews the lease. REQUIRES: !excludes(who, now).
  void take(ConnectionId id, model::Tick now, model::Tick lease) noexcept {
    holder_ = id;
    until_ = now + lease;
  }
  void release(ConnectionId id) noexcept {
    if (holder_ == id) {
      holder_ = 0;
      until_ = 0;
    }
  }

 private:
  ConnectionId holder_ = 0;
  model::Tick until_ = 0;
};

}  // namespace hedgehog::server
