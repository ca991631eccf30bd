// SPDX-License-Identifier: MIT
// connection.*
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/method_info.h"
#include "protocol/values/status.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

struct ConnectionInfo {
  std::int64_t connection = 0;
  std::optional<std::string> client{};
  std::string transport{};               // "tcp", "unix", "websocket"
  std::optional<std::string> address{};  // the peer's; null on a Unix socket
  // Peer credentials of a Unix socket at connect; omitted for other transports.
  std::optional<std::int64_t> uid{};
  std::optional<std::int64_t> pid{};
  Role role = Role::kObserve;
  double since_s = 0.0;  // seconds since it connected
  bool claimed = false;
  std::vector<EffectStatus> effects{};

  void describe(Fields& f) {
    f.required("connection", connection);
    f.nullable("client", client);
    f.required("transport", transport);
    f.nullable("address", address);
    f.optional("uid", uid);
    f.optional("pid", pid);
    f.required("role", role);
    f.required("since_s", since_s, decimals(1));
    f.required("claimed", claimed);
    f.required("effects", effects);
  }
  friend bool operator==(const ConnectionInfo&, const ConnectionInfo&) = default;
};

struct ConnectionsResult {
  static constexpr std::string_view kSchema = "Connections";
  std::vector<ConnectionInfo> connections{};

  void describe(Fields& f) { f.required("connections", connections); }
  friend bool operator==(const ConnectionsResult&, const ConnectionsResult&) = default;
};

struct ConnectionList {
  static constexpr MethodInfo kMethod{"connection.list", Role::kOperate,
                                      "The connections, with their start times and effects."};
  using Result = ConnectionsResult;
  friend bool operator==(const ConnectionList&, const ConnectionList&) = default;
};

using ConnectionMethods = TypeList<ConnectionList>;

}  // namespace hedgehog::protocol
