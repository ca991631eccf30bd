// SPDX-License-Identifier: MIT
// Which effects have started and ended, from the events of one connection that receives them all.
#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>

#include "protocol/wire/json.h"

namespace hedgehog::soak {

class EffectsModel {
 public:
  /// A response admitted it.
  void admitted(std::uint32_t effect);
  /// An event, in the order of arrival. Throws Failure on one that cannot be.
  void event(const protocol::Json& params);
  bool has_ended(std::uint32_t effect) const { return ended_.contains(effect); }
  /// Those that have been admitted or started and not ended, for a report; empty: none.
  std::string unended() const;

 private:
  std::set<std::uint32_t> open_;
  std::set<std::uint32_t> started_;
  std::set<std::uint32_t> ended_;
};

}  // namespace hedgehog::soak
