// SPDX-License-Identifier: MIT
// Access control of HTTP and WebSocket. Any web page can reach loopback: one of a foreign site is
// known by its `Origin`, or, where it only embeds or links something, by `Sec-Fetch-Site`; one by
// DNS rebinding by its `Host`. Pure functions.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/server/net/http/http_message.h"

namespace hedgehog::server {

/// "localhost", an address 127.x.x.x or "[::1]", with or without a port: ssh -L may have another.
bool is_own_host(std::string_view host);

/// Why not, as one sentence, and the `reason` of the metrics.
struct Refusal {
  HttpAnswer answer;
  std::string_view reason;
};

/// Below this path are files to download, which a foreign page may not even link.
inline constexpr std::string_view kRecordingsPath = "/recordings/";

/// nullopt: welcome. `allow_origins`: of the configuration, besides the pages we serve ourselves.
std::optional<Refusal> refused(const HttpRequest& request,
                               const std::vector<std::string>& allow_origins);

}  // namespace hedgehog::server
