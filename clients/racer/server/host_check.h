// SPDX-License-Identifier: MIT
// Access control of the game's page and its WebSocket. Any web page can reach loopback: one of a
// foreign site is detected by its `Origin`, DNS rebinding by its `Host`. Pure.
#pragma once

#include <optional>
#include <string_view>

namespace hedgehog::racer {

/// True if `Host` is localhost, 127.x.x.x or [::1] with any port, as with ssh -L.
bool is_own_host(std::string_view host);
/// True if `Origin`, if the browser sends one, is the page served from `host`.
bool may_connect(std::string_view host, std::optional<std::string_view> origin);

}  // namespace hedgehog::racer
