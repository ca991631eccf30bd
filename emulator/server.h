// SPDX-License-Identifier: MIT
// The emulator's one thread: a millisecond's beat, the talks with hosts, whoever imports, and
// whoever gives commands.
#pragma once

#include <csignal>
#include <list>
#include <string>

#include "daemon/device/socket_transport.h"
#include "emulator/hub.h"

namespace hedgehog::emulator {

/// Listening sockets. Throw std::system_error or std::runtime_error.
/// `address`: "127.0.0.1:3240" or "[::1]:3240"; port 0 takes a free one.
device::FileDescriptor listen_tcp(const std::string& address);
/// Its port.
int port_of(int socket);
/// 0600. What is left of an earlier one is replaced.
device::FileDescriptor listen_unix(const std::string& path);

class Server {
 public:
  /// `imports` and `commands`: listening, or empty. `console`: also commands from stdin, answered
  /// on stdout.
  Server(Hub& hub, device::FileDescriptor imports, device::FileDescriptor commands, bool console);

  /// Until the command `quit`, or `stop`.
  void run(const volatile std::sig_atomic_t& stop);

 private:
  struct Peer {
    device::FileDescriptor socket;
    bool commands = false;
    /// Where answers go, when that is not the socket.
    int answers = -1;
    std::string received;
    bool over = false;
  };
  void accept(const device::FileDescriptor& listener, bool commands);
  void read(Peer& peer);
  void obey(Peer& peer);
  void export_to(Peer& peer);

  Hub& hub_;
  device::FileDescriptor imports_;
  device::FileDescriptor commands_;
  std::list<Peer> peers_;
};

}  // namespace hedgehog::emulator
