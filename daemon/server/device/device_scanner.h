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
  /// Polled until it returns the result.
  using Ready = std::function<std::optional<protocol::DevicesResult>()>;
  /// Starts a scan. Empty: too many are pending.
  virtual Ready scan() = 0;
};

}  // namespace hedgehog::server
