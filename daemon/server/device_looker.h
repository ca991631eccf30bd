// SPDX-License-Identifier: MIT
// What device.list needs: somebody who looks at the devices of this machine while io goes on.
#pragma once

#include <functional>
#include <optional>

#include "protocol/results.h"

namespace hedgehog::server {

/// io thread.
class DeviceLooker {
 public:
  virtual ~DeviceLooker() = default;
  /// Asked again and again until it has the answer.
  using Ready = std::function<std::optional<protocol::DevicesResult>()>;
  /// Begins to look. Empty: too much is under way.
  virtual Ready look() = 0;
};

}  // namespace hedgehog::server
