// SPDX-License-Identifier: MIT
// A local port whose connections are forwarded by TLS to another port, so that clients without TLS
// reach a TLS listener.
#pragma once

#include <memory>

namespace hedgehog::e2e {

class TlsTunnel {
 public:
  /// Forwards to port `to` on 127.0.0.1; certificates are not verified.
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
