// SPDX-License-Identifier: MIT
// One HTTP connection, until it closes or becomes a WebSocket. Does not include Boost.Beast.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <functional>
#include <memory>
#include <optional>

#include "daemon/server/net/connection.h"
#include "daemon/server/net/http/website.h"
#include "daemon/server/net/tls_context.h"

namespace hedgehog::server {

/// One of the places for HTTP connections, until it is destroyed; empty by default.
class HttpPlace {
 public:
  HttpPlace() = default;
  explicit HttpPlace(std::shared_ptr<int> count) : count_(std::move(count)) { ++*count_; }
  HttpPlace(HttpPlace&&) noexcept = default;
  HttpPlace& operator=(HttpPlace&& other) noexcept {
    count_.swap(other.count_);
    return *this;
  }
  ~HttpPlace() {
    if (count_) --*count_;
  }
  explicit operator bool() const noexcept { return count_ != nullptr; }

 private:
  // Shared, because some connections are destroyed only with the io_context.
  std::shared_ptr<int> count_;
};

/// Dependencies of the HTTP connections, which it outlives. io thread only.
struct HttpEndpoint {
  Website site;
  Server& server;
  const config::ConnectionSettings& connections;
  /// The session of a new WebSocket, or nullopt at the limit of connections. With TLS it is locked.
  std::function<std::optional<Session>(boost::asio::ip::tcp::socket&, bool tls)> admit;
  std::function<void(std::shared_ptr<Connection>)> enter;  // registers an upgraded connection

  /// Maximum at a time, besides WebSockets; a browser opens up to six. With TLS only those that
  /// have sent a valid token are counted: the others are bounded by `HalfOpen`.
  static constexpr int kMaxClients = 64;
  std::shared_ptr<int> clients = std::make_shared<int>(0);
  /// Empty, and counted, if all are taken.
  HttpPlace place();
};

/// Bounds: 8 KiB of headers, 1 KiB of body (none is ever needed), 30 s until a request is received,
/// and as long again, with a second for each 32 KiB, for its response. REQUIRES: `place`.
boost::asio::awaitable<void> serve_http(boost::asio::ip::tcp::socket socket, HttpEndpoint& endpoint,
                                        HttpPlace place);
/// The same with TLS. `ticket` is released after a valid token, for a place of `endpoint`.
boost::asio::awaitable<void> serve_https(boost::asio::ip::tcp::socket socket,
                                         HttpEndpoint& endpoint, TlsContext context,
                                         HalfOpen::Ticket ticket);

}  // namespace hedgehog::server
