// SPDX-License-Identifier: MIT
// Access control of HTTP and WebSocket by pure functions. A foreign site is detected by `Origin`,
// or, if it only embeds or links a resource, by `Sec-Fetch-Site`; DNS rebinding by `Host`.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/server/net/http/http_message.h"

namespace hedgehog::server {

/// "localhost", 127.x.x.x or "[::1]", with any port or none: ssh -L may use another one.
bool is_own_host(std::string_view host);

/// The reason as one sentence, and the `reason` of the metrics.
struct Refusal {
  HttpResponse answer;
  std::string_view reason;
};

/// Files to download below this path, which a foreign page may not even link.
inline constexpr std::string_view kRecordingsPath = "/recordings/";

/// nullopt: accepted. `allow_origins`: from the configuration, besides the pages served here.
std::optional<Refusal> refused(const HttpRequest& request,
                               const std::vector<std::string>& allow_origins);

}  // namespace hedgehog::server
