// SPDX-License-Identifier: MIT
// A daemon that also listens with TLS, with the tokens and the certificate created by hedgehogctl.
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/program.h"
#include "tests/e2e/programs.h"

namespace hedgehog::e2e {

class TlsFixture : public testing::Test {
 protected:
  TlsFixture() {
    home_.configure(R"({"http": {"listen": "tls://127.0.0.1:0"}})");
    play_ = made({"token", "add", "arcade", "--role", "play"});
    operate_ = made({"token", "add", "owner", "--role", "operate"});
    fingerprint_ = made({"token", "certificate"});
  }

  /// Output of `hedgehogctl` with `words`, without its line end.
  std::string made(const std::vector<std::string>& words) {
    const Ended ended = ctl(words, {});
    EXPECT_EQ(ended.exit_code, 0) << ended.err;
    return ended.out.substr(0, ended.out.find('\n'));
  }
  Ended ctl(std::vector<std::string> words, const std::vector<std::string>& variables) {
    if (words[0] == "token") words.insert(words.end(), {"--state", home_.path("state/hedgehog")});
    return Program(home_, hedgehogctl(), words, variables).wait();
  }
  /// Environment of a client that connects to `daemon` by TLS.
  std::vector<std::string> variables(const std::string& token) const {
    return {"HEDGEHOG_ADDRESS=tls://127.0.0.1:" + std::to_string(port("tls://")),
            "HEDGEHOG_TOKEN=" + token, "HEDGEHOG_FINGERPRINT=" + fingerprint_};
  }
  /// Port of the daemon's listener with `scheme`, "tls://" or "https://".
  int port(const std::string& scheme) const {
    const std::string line = "listening on " + scheme + "127.0.0.1:";
    const std::string out = home_.read("out");
    const auto at = out.find(line);
    return at == std::string::npos ? 0 : std::stoi(out.substr(at + line.size()));
  }

  Home home_;
  std::string play_;
  std::string operate_;
  std::string fingerprint_;
};

}  // namespace hedgehog::e2e
