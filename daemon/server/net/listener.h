// SPDX-License-Identifier: MIT
// Listening sockets: TCP, a Unix socket, and HTTP; TCP and HTTP with TLS if reachable by other
// machines. An accepted socket becomes a Connection; on HTTP, a WebSocket does.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <chrono>
#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "daemon/config/config.h"
#include "daemon/server/net/connection.h"
#include "daemon/server/net/http/http_connection.h"
#include "daemon/server/net/inherited_sockets.h"
#include "daemon/server/net/line/ring.h"
#include "daemon/server/rpc/server.h"

namespace hedgehog::server {

/// io thread only, once started.
class Listener {
 public:
  Listener(boost::asio::io_context& io, const config::Config& config);
  ~Listener();

  /// Opens every address of `listen` and `http`, or takes the socket that systemd has opened for
  /// it. Throws std::runtime_error with a sentence for display.
  void open(const config::Config& config);
  /// Endpoints: "127.0.0.1:7586", "tls://192.0.2.7:7586", "http://127.0.0.1:7587",
  /// "https://192.0.2.7:7587", "/run/hedgehog/hedgehogd.sock".
  const std::vector<std::string>& addresses() const noexcept { return addresses_; }
  /// Accepts clients. `server` must outlive the io_context's work.
  void start(Server& server);
  /// Accepts no more clients; connected ones get their queued lines and are closed.
  void close();
  bool empty() const noexcept;

  /// Applies limits, the mode of the Unix socket, and certificate and key for new connections.
  void set_config(const config::Config& config);

 private:
  using Acceptor = boost::asio::ip::tcp::acceptor;
  struct TcpListener {
    Acceptor acceptor;
    bool tls;
  };
  /// nullopt: this machine has no IPv6.
  std::optional<TcpListener> open_tcp(const config::ListenAddress& address,
                                      InheritedSockets& inherited, const char* remedy);
  void open_unix(const std::string& path, const access::UnixRoles& roles);
  template <class AnyAcceptor, class OnAccept>
  boost::asio::awaitable<void> accept(AnyAcceptor& acceptor, OnAccept on_accept);
  template <class AnySocket>
  Session session_with(AnySocket& socket, const char* transport = nullptr) const;
  /// Opens the ring of plain connections if there may be enough of them and it is not open.
  void open_ring();
  void start_session(boost::asio::generic::stream_protocol::socket socket, Session session);
  void start_http(boost::asio::ip::tcp::socket socket);
  boost::asio::awaitable<void> start_tls_session(boost::asio::ip::tcp::socket socket);
  void start_https(boost::asio::ip::tcp::socket socket);
  HalfOpen::Ticket half_open(boost::asio::ip::tcp::socket& socket);
  /// Capacity for one more; false, and counted, when all places are used; false during a shutdown.
  bool has_capacity(const Session& session);
  void enter(const std::shared_ptr<Connection>& connection);
  /// Usually out of file descriptors. Reported once per episode.
  void report_accept_failure(const boost::system::error_code& error);

  boost::asio::io_context& io_;
  config::ConnectionSettings settings_;
  TlsContext tls_;
  std::shared_ptr<HalfOpen> half_open_;
  config::HttpSettings http_settings_;
  std::list<TcpListener> tcp_;
  std::optional<TcpListener> http_;
  std::optional<HttpEndpoint> http_endpoint_;
  std::unique_ptr<Ring> ring_;
  Server* server_ = nullptr;
  bool closing_ = false;
  std::optional<std::chrono::steady_clock::time_point> accept_failed_at_;
  std::optional<boost::asio::local::stream_protocol::acceptor> unix_;
  std::string unix_path_;
  std::uint64_t unix_inode_ = 0;
  std::vector<std::string> addresses_;
  std::list<std::weak_ptr<Connection>> connections_;
};

}  // namespace hedgehog::server
