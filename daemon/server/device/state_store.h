// SPDX-License-Identifier: MIT
// Interface of the persistent state for handlers.
#pragma once

#include <cstdint>

#include "daemon/control/state/state.h"

namespace hedgehog::server {

enum class Persisted : std::uint8_t {
  kPending,
  kYes,
  kNo,  // the write failed; it is repeated
};

/// Called on the io thread; written on the disk thread.
class StateStore {
 public:
  virtual ~StateStore() = default;
  virtual void persist_gain(double gain) = 0;  // the owner's
  /// Persists a latch that control has not confirmed yet; returns the number of the write with it.
  virtual std::uint64_t persist_latch(control::Reason latch) = 0;
  /// State of that write, or of a later one.
  virtual Persisted latch_persisted(std::uint64_t write) const = 0;
};

}  // namespace hedgehog::server
