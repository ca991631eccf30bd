// SPDX-License-Identifier: MIT
#include "clients/ctl/discover/discovery.h"

#include "clients/lib/connection.h"

namespace hedgehog::client {
namespace {

void introduce(RespondingDaemon& found) {
  auto connection = Connection::start({.path = found.daemon.socket});
  const auto connected = connection
                             ? connection->connected(Clock::now() + Connection::kConnectTimeout)
                             : Outcome<bool>(connection.error());
  if (!connected || !*connected) {
    found.failure = connected ? "does not respond" : connected.error().message;
    return;
  }
  auto hello = connection->hello("hedgehogctl");
  if (!hello) {
    found.failure = hello.error().message;
    return;
  }
  found.hello = *std::move(hello);
  if (const auto description = connection->call(protocol::DeviceDescribe{}))
    found.serial = description->board.serial;
}

}  // namespace

std::vector<LocalDaemon> running_daemons(const Environment& environment) {
  std::vector<LocalDaemon> daemons = local_daemons(environment);
  std::erase_if(daemons, [](const LocalDaemon& daemon) {
    auto connection = Connection::start({.path = daemon.socket});
    const auto connected =
        connection ? connection->connected(Clock::now()) : Outcome<bool>(connection.error());
    return !connected && (connected.error().message == "connection refused" ||
                          connected.error().message == "no such file or directory");
  });
  return daemons;
}

std::vector<RespondingDaemon> search_machine(const Environment& environment) {
  std::vector<RespondingDaemon> all;
  for (LocalDaemon& daemon : running_daemons(environment)) {
    all.push_back({std::move(daemon), {}, {}, {}});
    introduce(all.back());
  }
  return all;
}

}  // namespace hedgehog::client
