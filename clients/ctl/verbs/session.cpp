// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/session.h"

#include "clients/common/terminal.h"

namespace hedgehog::client {

Outcome<Session> open_session(const CommonOptions& options) {
  const auto addresses = daemon_addresses(options.address);
  if (!addresses) return addresses.error();
  auto connection = Connection::open(*addresses);
  if (!connection) return connection.error();
  const TerminalTraits traits = terminal_traits();
  return Session{*std::move(connection),
                 options.json,
                 {.colour = traits.colour, .ascii = traits.ascii, .cuts = traits.has_edge}};
}

Outcome<Ball> look(Connection& connection) {
  Ball ball;
  auto hello = connection.hello("hedgehogctl");
  if (!hello) return hello.error();
  ball.hello = *std::move(hello);
  auto description = connection.call(protocol::DeviceDescribe{});
  if (!description) return description.error();
  ball.description = *std::move(description);
  auto status = connection.call(protocol::DeviceStatus{});
  if (!status) return status.error();
  ball.status = *std::move(status);
  return ball;
}

}  // namespace hedgehog::client
