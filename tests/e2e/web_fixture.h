// SPDX-License-Identifier: MIT
// A daemon that serves pages.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/web_client.h"

namespace hedgehog::e2e {

inline const std::string kPingRequest = R"({"jsonrpc":"2.0","id":1,"method":"ping"})";

struct PagesHome : Home {
  PagesHome() {
    write("www/index.html", "<!doctype html><title>ball</title>");
    write("www/app.js", "export {};");
    write("www/deep/style.css", "a{}");
    write("www/secret.key", "not a page");
    write("outside.html", "not ours");
    configure(R"({"http": {"pages": ")" + path("www") +
              R"(", "allow_origins": ["https://game.example"]}})");
  }
};

class Web : public testing::Test {
 protected:
  WebResponse get(const std::string& target, const std::string& more = "",
                  const std::string& method = "GET") {
    return web_get(daemon_.http_port(), target, more, method);
  }
  /// Value of the line of /metrics that begins with `name`.
  double metric(const std::string& name) {
    const std::string text = "\n" + get("/metrics").body;
    const auto at = text.find("\n" + name + " ");
    return at == std::string::npos ? -1.0 : std::stod(text.substr(at + name.size() + 2));
  }

  PagesHome home_;
  DaemonProcess daemon_{home_};
};

}  // namespace hedgehog::e2e
