// SPDX-License-Identifier: MIT
// Access control of the game's page and its WebSocket. Any web page can reach loopback: one of a
// foreign site is detected by its `Origin`, DNS rebinding by its `Host`. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::racer {

struct HostCheck {
  /// The address of `--listen`: "127.0.0.1", "192.168.1.5", "0.0.0.0", "::".
  std::string address;
  /// The bound port.
  std::uint16_t port = 0;

  /// True if `Host` is localhost, 127.x.x.x or [::1] with any port, as with ssh -L, or the address
  /// listened on with the bound port. When listening on every address, any IP address is accepted,
  /// since DNS rebinding requires a name.
  bool is_own_host(std::string_view host) const;
  /// True if `Origin`, if the browser sends one, is the page served from `host`.
  bool may_connect(std::string_view host, std::optional<std::string_view> origin) const;
};

}  // namespace hedgehog::racer
