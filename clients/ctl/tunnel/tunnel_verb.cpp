// SPDX-License-Identifier: MIT
#include "clients/ctl/tunnel/tunnel_verb.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "clients/ctl/exit_code.h"
#include "clients/ctl/tunnel/tunnel.h"
#include "clients/lib/connection.h"
#include "protocol/wire/role.h"

namespace hedgehog::client {
namespace {

using TunnelRole = std::optional<protocol::Role>;

/// One connection, so that what is wrong is reported at once: the role of the token; nullopt: there
/// is no token.
Outcome<TunnelRole> role_at(const std::vector<Address>& addresses) {
  auto connection = Connection::open(addresses);
  if (!connection) return connection.error();
  if (!addresses.front().token) return TunnelRole();
  const auto hello = connection->hello("hedgehogctl tunnel");
  if (!hello) return hello.error();
  return TunnelRole(hello->role);
}

void print_as_json(const std::string& listening, const std::string& address, TunnelRole role) {
  nlohmann::ordered_json line{{"listening", listening}, {"address", address}, {"role", nullptr}};
  if (role) line["role"] = protocol::name(*role);
  std::printf("%s\n", line.dump().c_str());
}

void print_as_text(const std::string& listening, const std::string& address, TunnelRole role) {
  std::printf("HEDGEHOG_ADDRESS=%s\n", listening.c_str());
  std::fflush(stdout);
  if (!role) {
    std::fprintf(stderr,
                 "Games reach %s there until Ctrl-C. HEDGEHOG_TOKEN is not set: each has to send a "
                 "token of its own.\n",
                 address.c_str());
    return;
  }
  std::fprintf(stderr,
               "Every program of this machine reaches %s there, with the role %s, until Ctrl-C.\n",
               address.c_str(), std::string(protocol::name(*role)).c_str());
  if (*role == protocol::Role::kOperate)
    std::fputs("For games a token with the role play suffices.\n", stderr);
}

}  // namespace

int run_tunnel(const CommonOptions& common, const TunnelOptions& options) {
  const auto addresses = daemon_addresses(common.address);
  if (!addresses) return report_error(addresses.error());
  const std::string address = to_string(addresses->front());
  if (!addresses->front().tls) {
    return report_error({Failure::kBadAddress,
                         "a tunnel leads to a ball on the network, tls://host:port or mdns://NAME, "
                         "not to " +
                             address,
                         {}});
  }
  Tunnel tunnel(*addresses, [](const ClientError& problem) { report_error(problem); });
  const auto port = tunnel.listen(static_cast<std::uint16_t>(options.port));
  if (!port) {
    print_failure("failed", port.error().message);
    return port.error().exit_code;
  }
  const auto role = role_at(*addresses);
  if (!role) return report_error(role.error());
  const std::string listening = "127.0.0.1:" + std::to_string(*port);
  if (common.json)
    print_as_json(listening, address, *role);
  else
    print_as_text(listening, address, *role);
  std::fflush(stdout);
  tunnel.run();
  return kInterrupted;
}

}  // namespace hedgehog::client
