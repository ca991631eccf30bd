// SPDX-License-Identifier: MIT
// The emulator's single thread: 1 ms tick, host sessions, import requests and commands.
#pragma once

#include <csignal>
#include <list>
#include <string>

#include "daemon/device/socket_transport.h"
#include "emulator/hub.h"

namespace hedgehog::emulator {

/// Listening sockets. Throw std::system_error or std::runtime_error. `address`: "127.0.0.1:3240" or
/// "[::1]:3240"; port 0: any free port.
device::FileDescriptor listen_tcp(const std::string& address);
/// Port of a listening socket.
int port_of(int socket);
/// Mode 0600. Replaces a stale socket.
device::FileDescriptor listen_unix(const std::string& path);

class Server {
 public:
  /// `imports` and `commands`: listening, or empty. `console`: also commands from stdin, with
  /// responses on stdout.
  Server(Hub& hub, device::FileDescriptor imports, device::FileDescriptor commands, bool console);

  /// Runs until the command `quit`, or `stop`.
  void run(const volatile std::sig_atomic_t& stop);

 private:
  struct Peer {
    device::FileDescriptor socket;
    bool commands = false;
    /// File descriptor for responses: the socket, or stdout for the console.
    int answers = -1;
    std::string received;
    bool over = false;
  };
  void accept(const device::FileDescriptor& listener, bool commands);
  void read(Peer& peer);
  void run_commands(Peer& peer);
  void export_to(Peer& peer);

  Hub& hub_;
  device::FileDescriptor imports_;
  device::FileDescriptor commands_;
  std::list<Peer> peers_;
};

}  // namespace hedgehog::emulator
