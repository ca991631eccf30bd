// SPDX-License-Identifier: MIT
// A daemon with TLS, and `hedgehogctl tunnel` in front of it.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>
#include <vector>

#include "tests/e2e/exit_codes.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"
#include "tests/e2e/tls_fixture.h"

namespace hedgehog::e2e {

/// At a free port, once it listens.
class TunnelProcess {
 public:
  /// `words`: behind `hedgehogctl tunnel --port 0`.
  TunnelProcess(const Home& home, const std::vector<std::string>& variables,
                std::vector<std::string> words = {})
      : program_(home, hedgehogctl(), with_port(std::move(words)), variables) {
    const std::string line = "HEDGEHOG_ADDRESS=127.0.0.1:";
    const bool listens = eventually([&] {
      const std::string out = program_.out();
      if (!out.starts_with(line) || !out.ends_with('\n')) return false;
      port_ = std::stoi(out.substr(line.size()));
      return true;
    });
    EXPECT_TRUE(listens) << program_.err();
  }

  int port() const noexcept { return port_; }
  /// Environment of a client without token and fingerprint.
  std::vector<std::string> variables() const {
    return {"HEDGEHOG_ADDRESS=127.0.0.1:" + std::to_string(port_)};
  }
  Program& program() noexcept { return program_; }

 private:
  static std::vector<std::string> with_port(std::vector<std::string> words) {
    words.insert(words.begin(), {"tunnel", "--port", "0"});
    return words;
  }

  Program program_;
  int port_ = 0;
};

class TunnelFixture : public TlsFixture {
 protected:
  TunnelFixture() { start("tls://127.0.0.1:0"); }

  /// Starts the daemon.
  void start(const std::string& listen) {
    daemon_.emplace(home_, std::vector<std::string>{"--listen", listen});
  }
  std::string tls_address() const { return "tls://127.0.0.1:" + std::to_string(port("tls://")); }
  /// The status as a client of the Unix socket sees it.
  Json status() const { return RawClient(daemon_->socket()).call("device.status"); }
  bool plays_nothing() const {
    return eventually([&] { return status()["effects"].empty(); });
  }
  /// Requests whose responses have 10 kB each: 20 MB, more than the system buffers.
  static constexpr int kManyRequests = 2000;
  static std::string many_requests() {
    std::string all;
    for (int i = 0; i < kManyRequests; ++i)
      all += R"({"jsonrpc":"2.0","id":7,"method":"device.describe"})"
             "\n";
    return all;
  }
  /// Begins an effect that lasts.
  static void hold(RawClient& client) {
    const Json held = client.call("effect.hold", {{"direction", "up"}, {"lease_ms", 10'000}});
    EXPECT_EQ(held["accepted"], true) << held;
  }

  std::optional<DaemonProcess> daemon_;
};

}  // namespace hedgehog::e2e
