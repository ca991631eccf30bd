// SPDX-License-Identifier: MIT
// Listening sockets that systemd has opened for the daemon (a socket unit, sd_listen_fds(3)): the
// service itself then needs no permission to exchange packets with other machines.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <vector>

namespace hedgehog::server {

/// Owns the descriptors until they are taken. io thread only.
class InheritedSockets {
 public:
  /// Those passed by systemd, if any. What is not a listening TCP socket is closed, with a warning.
  InheritedSockets();
  InheritedSockets(const InheritedSockets&) = delete;
  InheritedSockets& operator=(const InheritedSockets&) = delete;
  ~InheritedSockets();  // closes those that were not taken

  /// The descriptor of the socket at `endpoint`, which the caller then owns; -1: there is none.
  int take(const boost::asio::ip::tcp::endpoint& endpoint) noexcept;
  /// Logs a warning for each that was not taken: its clients would wait in vain.
  void warn_of_unused() const;

 private:
  struct Socket {
    boost::asio::ip::tcp::endpoint endpoint;
    int descriptor;
  };
  std::vector<Socket> sockets_;
};

}  // namespace hedgehog::server
