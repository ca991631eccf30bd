// SPDX-License-Identifier: MIT
// Lines on TCP with TLS.
#pragma once

#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/stream.hpp>

#include "daemon/server/net/line/line_connection.h"

namespace hedgehog::server {

class TlsConnection final : public LineConnection {
 public:
  using Stream = boost::asio::ssl::stream<boost::asio::ip::tcp::socket>;

  /// `stream`: after its handshake.
  TlsConnection(Stream stream, Server& server, Session session,
                const config::ConnectionSettings& settings);

 private:
  boost::asio::awaitable<void> read() override;
  boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) override;
  boost::asio::awaitable<void> finish_stream() override;
  void close() noexcept override;
  std::size_t unread_bytes() noexcept override;

  Stream stream_;
};

}  // namespace hedgehog::server
