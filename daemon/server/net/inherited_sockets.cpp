// SPDX-License-Identifier: MIT
#include "daemon/server/net/inherited_sockets.h"

#include <spdlog/spdlog.h>
#include <sys/socket.h>
#include <systemd/sd-daemon.h>
#include <unistd.h>

#include <algorithm>
#include <optional>

#include "daemon/server/net/tcp_acceptor.h"

namespace hedgehog::server {
namespace {

using Tcp = boost::asio::ip::tcp;

/// nullopt: not a listening TCP socket.
std::optional<Tcp::endpoint> endpoint_of(int descriptor) {
  constexpr int kListening = 1;
  if (sd_is_socket_inet(descriptor, AF_UNSPEC, SOCK_STREAM, kListening, 0) <= 0) return {};
  Tcp::endpoint endpoint;
  socklen_t size = static_cast<socklen_t>(endpoint.capacity());
  if (::getsockname(descriptor, endpoint.data(), &size) != 0) return {};
  endpoint.resize(size);
  return endpoint;
}

}  // namespace

InheritedSockets::InheritedSockets() {
  // Removing them is not safe with threads, and not needed: they name this process.
  constexpr int kKeepVariables = 0;
  const int count = sd_listen_fds(kKeepVariables);
  for (int i = 0; i < count; ++i) {
    const int descriptor = SD_LISTEN_FDS_START + i;
    if (const auto endpoint = endpoint_of(descriptor)) {
      sockets_.push_back({*endpoint, descriptor});
    } else {
      spdlog::warn("systemd has passed descriptor {}, which is not a listening TCP socket; closed",
                   descriptor);
      ::close(descriptor);
    }
  }
}

InheritedSockets::~InheritedSockets() {
  for (const Socket& socket : sockets_) ::close(socket.descriptor);
}

void InheritedSockets::warn_of_unused() const {
  for (const Socket& socket : sockets_) {
    spdlog::warn(
        "{}: a socket unit of systemd listens there, but the configuration does not; add it to "
        "listen.tcp or http.listen",
        endpoint_text(socket.endpoint));
  }
}

int InheritedSockets::take(const Tcp::endpoint& endpoint) noexcept {
  const auto found = std::find_if(sockets_.begin(), sockets_.end(), [&](const Socket& socket) {
    return socket.endpoint == endpoint;
  });
  if (found == sockets_.end()) return -1;
  const int descriptor = found->descriptor;
  sockets_.erase(found);
  return descriptor;
}

}  // namespace hedgehog::server
