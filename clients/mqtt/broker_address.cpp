// SPDX-License-Identifier: MIT
#include "clients/mqtt/broker_address.h"

#include <fstream>
#include <string>

#include "clients/lib/address.h"

namespace hedgehog::mqtt {

Result<void> set_address(BrokerOptions& options, std::string_view text) {
  std::string_view rest = text;
  constexpr std::string_view kPlain = "mqtt://";
  constexpr std::string_view kTls = "mqtts://";
  if (rest.starts_with(kTls)) {
    options.tls = true;
    rest.remove_prefix(kTls.size());
  } else if (rest.starts_with(kPlain)) {
    rest.remove_prefix(kPlain.size());
  }
  const auto address = client::parse_address(rest);
  if (!address || rest.empty() || address->mdns)
    return Problem(EX_USAGE, "'" + std::string(text) +
                                 "' is no broker: host, host:port, mqtts://host:port or the path "
                                 "of a socket");
  if (!address->path.empty()) {
    options.host = address->path;
    options.port = 0;
    return {};
  }
  options.host = address->host;
  const auto digits = rest.substr(rest.rfind(':') + 1);
  const bool has_port = digits.size() < rest.size() &&
                        digits.find_first_not_of("0123456789") == digits.npos &&
                        (rest.starts_with('[') ? rest.find("]:") != rest.npos
                                               : address->host.find(':') == std::string::npos);
  options.port = has_port ? address->port : options.tls ? kMqttTlsPort : kMqttPort;
  return {};
}

Result<std::string> password_of(const std::string& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line) || line.empty())
    return Problem(EX_NOINPUT, file + " has no password in its first line");
  if (line.ends_with('\r')) line.pop_back();
  return line;
}

}  // namespace hedgehog::mqtt
