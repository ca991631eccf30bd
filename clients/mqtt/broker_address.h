// SPDX-License-Identifier: MIT
// Where a broker is, as a person writes it.
#pragma once

#include <string_view>

#include "clients/common/problem.h"
#include "clients/mqtt/broker.h"

namespace hedgehog::mqtt {

/// Sets host, port and tls from "host", "host:port", "[::1]:port", "mqtt://...", "mqtts://..." or
/// the path of a Unix socket ("/run/mosquitto.sock"). Without a port 1883, with TLS 8883. EX_USAGE:
/// a sentence with what is wrong.
Result<void> set_address(BrokerOptions& options, std::string_view text);

/// The first line of the file of a password, without its end of line. EX_NOINPUT: it cannot be
/// read, or is empty.
Result<std::string> password_of(const std::string& file);

}  // namespace hedgehog::mqtt
