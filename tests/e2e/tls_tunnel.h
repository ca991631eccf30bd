// SPDX-License-Identifier: MIT
// A port on this machine whose connections are carried to another by TLS, so that clients without
// TLS speak to a listener with it.
#pragma once

#include <memory>

namespace hedgehog::e2e {

class TlsTunnel {
 public:
  /// To port `to` on 127.0.0.1; certificates are not looked at.
  explicit TlsTunnel(int to);
  TlsTunnel(const TlsTunnel&) = delete;
  TlsTunnel& operator=(const TlsTunnel&) = delete;
  ~TlsTunnel();

  int port() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hedgehog::e2e
