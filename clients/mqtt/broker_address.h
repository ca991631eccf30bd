// SPDX-License-Identifier: MIT
// Parsing of a broker's address.
#pragma once

#include <string_view>

#include "clients/common/problem.h"
#include "clients/mqtt/broker.h"

namespace hedgehog::mqtt {

/// Sets host, port and tls from "host", "host:port", "[::1]:port", "mqtt://...", "mqtts://..." or
/// the path of a Unix socket ("/run/mosquitto.sock"). Default port 1883, with TLS 8883. EX_USAGE: a
/// sentence with the error.
Result<void> set_address(BrokerOptions& options, std::string_view text);

/// The first line of a password file, without its line end. EX_NOINPUT: it cannot be read, or is
/// empty.
Result<std::string> password_of(const std::string& file);

}  // namespace hedgehog::mqtt
