// SPDX-License-Identifier: MIT
// Persistent state, as handlers use it.
#pragma once

#include <cstdint>

#include "daemon/control/state/state.h"

namespace hedgehog::server {

enum class Persisted : std::uint8_t {
  kPending,
  kYes,
  kNo,  // the disk has refused; it is asked again
};

/// Called on the io thread; written on the disk thread.
class StateStore {
 public:
  virtual ~StateStore() = default;
  /// The owner's gain.
  virtual void persist_gain(double gain) = 0;
  /// A latch that the control thread has not confirmed yet. Returns the number of the write that
  /// has it.
  virtual std::uint64_t persist_latch(control::Reason latch) = 0;
  /// Whether that write, or a later one, is on disk.
  virtual Persisted latch_persisted(std::uint64_t write) const = 0;
};

}  // namespace hedgehog::server
