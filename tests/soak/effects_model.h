// SPDX-License-Identifier: MIT
// The started and ended effects, from the events of a connection that receives all of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "protocol/wire/json.h"

namespace hedgehog::soak {

class EffectsModel {
 public:
  /// Called when a response has admitted the effect.
  void admitted(std::uint32_t effect);
  /// Processes an event, in order of arrival. Throws Failure on an impossible one.
  void event(const protocol::Json& params);
  bool has_ended(std::uint32_t effect) const { return ended_.contains(effect); }
  /// The effects that have been admitted or started and not ended, for a report; empty: none.
  std::string active() const;

 private:
  std::set<std::uint32_t> open_;
  std::set<std::uint32_t> started_;
  std::set<std::uint32_t> ended_;
};

}  // namespace hedgehog::soak
