// SPDX-License-Identifier: MIT
// Doors: TCP on loopback and a Unix socket. Everybody who comes in becomes a Connection.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/local/stream_protocol.hpp>
#include <cstddef>
#include <list>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "daemon/config/config.h"
#include "daemon/server/connection.h"
#include "daemon/server/server.h"

namespace hedgehog::server {

/// io thread only, once started.
class Listener {
 public:
  Listener(boost::asio::io_context& io, const config::Config& config);
  ~Listener();

  /// Opens every address of `listen`. Throws std::runtime_error with a sentence for a person.
  void open(const config::ListenSettings& listen);
  /// Where it waits: "127.0.0.1:7586", "/run/hedgehog/hedgehogd.sock".
  const std::vector<std::string>& addresses() const noexcept { return addresses_; }
  /// Lets clients in. `server` must outlive the io_context's work.
  void start(Server& server);
  /// No new clients; those who are there hear what waits for them and are closed.
  void close();
  bool empty() const noexcept;

  void set_config(const config::Config& config) noexcept { settings_ = config.connections; }

 private:
  void open_tcp(const config::ListenAddress& address);
  void open_unix(const std::string& path);
  template <class Acceptor>
  boost::asio::awaitable<void> accept(Acceptor& acceptor, Server& server);
  void let_in(Connection::Socket socket, Session session, Server& server);

  boost::asio::io_context& io_;
  config::ConnectionSettings settings_;
  bool simulated_;
  std::list<boost::asio::ip::tcp::acceptor> tcp_;
  std::optional<boost::asio::local::stream_protocol::acceptor> unix_;
  std::string unix_path_;
  std::uint64_t unix_inode_ = 0;
  std::vector<std::string> addresses_;
  std::list<std::weak_ptr<Connection>> connections_;
};

}  // namespace hedgehog::server
