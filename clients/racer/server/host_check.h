// SPDX-License-Identifier: MIT
// Who may have the game's page and its WebSocket. Any web page can reach loopback: one of a foreign
// site is known by its `Origin`, one whose name was bent to us (DNS rebinding) by its `Host`. Pure.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace hedgehog::racer {

struct HostCheck {
  /// What `--listen` named: "127.0.0.1", "192.168.1.5", "0.0.0.0", "::".
  std::string address;
  /// The bound one.
  std::uint16_t port = 0;

  /// `Host` is localhost, 127.x.x.x or [::1] with any port, as ssh -L gives one, or the address
  /// listened on with the bound port. When every address is listened on, any address will do, since
  /// a name of DNS rebinding is none.
  bool is_ours(std::string_view host) const;
  /// `Origin`, where the browser sends one, is the page that came from `host`.
  bool may_connect(std::string_view host, std::optional<std::string_view> origin) const;
};

}  // namespace hedgehog::racer
