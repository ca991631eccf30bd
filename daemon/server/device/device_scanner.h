// SPDX-License-Identifier: MIT
// Asynchronous scan of the devices on this machine's buses, for device.list.
#pragma once

#include <functional>
#include <optional>

#include "protocol/methods.h"

namespace hedgehog::server {

/// io thread.
class DeviceScanner {
 public:
  virtual ~DeviceScanner() = default;
  /// Asked again and again until it has the answer.
  using Ready = std::function<std::optional<protocol::DevicesResult>()>;
  /// Begins to look. Empty: too much is under way.
  virtual Ready look() = 0;
};

}  // namespace hedgehog::server
