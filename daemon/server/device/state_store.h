// SPDX-License-Identifier: MIT
// Persistent state, as handlers use it.
#pragma once

#include "daemon/control/state/state.h"

namespace hedgehog::server {

/// Called on the io thread; written on the disk thread.
class StateStore {
 public:
  virtual ~StateStore() = default;
  /// The owner's gain.
  virtual void persist_gain(double gain) = 0;
  /// A latch that the control thread has not confirmed yet.
  virtual void persist_latch(control::Reason latch) = 0;
};

}  // namespace hedgehog::server
