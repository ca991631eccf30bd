// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/session.h"

#include <csignal>

#include "clients/ctl/terminal/terminal.h"

namespace hedgehog::client {

namespace {

volatile std::sig_atomic_t interrupt_seen = 0;

void note_interrupt(int) { interrupt_seen = 1; }

}  // namespace

Outcome<Session> open_session(const CommonOptions& options) {
  const auto addresses = daemon_addresses(options.address);
  if (!addresses) return addresses.error();
  auto connection = Connection::open(*addresses);
  if (!connection) return connection.error();
  const TerminalTraits traits = terminal_traits();
  return Session{
      *std::move(connection), options.json, {.colour = traits.colour, .ascii = traits.ascii}};
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

bool interrupted() noexcept { return interrupt_seen != 0; }

void watch_interrupts() {
  struct sigaction action {};
  action.sa_handler = note_interrupt;
  sigemptyset(&action.sa_mask);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
  // The terminal went away.
  sigaction(SIGHUP, &action, nullptr);
}

}  // namespace hedgehog::client
