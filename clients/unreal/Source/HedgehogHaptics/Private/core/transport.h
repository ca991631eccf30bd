// SPDX-License-Identifier: MIT
// A stream of bytes to the daemon. No call waits.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

#include "core/address.h"

namespace hedgehog::unreal {

/// One thread. Closes when it goes away.
class Transport {
 public:
  enum class State { kConnecting, kOpen, kEnded };

  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  virtual State state() = 0;
  /// As many bytes as can be sent now; `ended` when there will be no more.
  virtual std::size_t send(std::string_view bytes, bool& ended) = 0;
  /// As many as came and fit; `ended` when there will be no more.
  virtual std::size_t receive(char* bytes, std::size_t size, bool& ended) = 0;
};

/// Never null; what cannot be reached ends.
using Connect = std::function<std::unique_ptr<Transport>(const Address&)>;

}  // namespace hedgehog::unreal
