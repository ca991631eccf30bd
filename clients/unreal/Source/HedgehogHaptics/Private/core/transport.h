// SPDX-License-Identifier: MIT
// A stream of bytes to the daemon. No call blocks.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string_view>

#include "core/address.h"

namespace hedgehog::unreal {

/// One thread. The destructor closes it.
class Transport {
 public:
  enum class State { kConnecting, kOpen, kEnded };

  Transport() = default;
  Transport(const Transport&) = delete;
  Transport& operator=(const Transport&) = delete;
  virtual ~Transport() = default;

  virtual State state() = 0;
  /// Sends as many bytes as possible; `ended` if no more can be sent.
  virtual std::size_t send(std::string_view bytes, bool& ended) = 0;
  /// Reads as many bytes as were received and fit; `ended` if no more will be received.
  virtual std::size_t receive(char* bytes, std::size_t size, bool& ended) = 0;
};

/// Never null; an unreachable address results in kEnded.
using Connect = std::function<std::unique_ptr<Transport>(const Address&)>;

}  // namespace hedgehog::unreal
