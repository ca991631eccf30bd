// SPDX-License-Identifier: MIT
// A client on TCP or on the Unix socket: one message a line.
#pragma once

#include <boost/asio/generic/stream_protocol.hpp>

#include "daemon/server/net/connection.h"
#include "daemon/server/net/line_reader.h"

namespace hedgehog::server {

class LineConnection final : public Connection {
 public:
  using Socket = boost::asio::generic::stream_protocol::socket;

  LineConnection(Socket socket, Server& server, Session session,
                 const config::ConnectionSettings& settings)
      : Connection(socket.get_executor(), server, std::move(session), settings),
        socket_(std::move(socket)) {
    // For `send_now`; what waits is not concerned.
    boost::system::error_code ignored;
    socket_.non_blocking(true, ignored);
  }

 private:
  boost::asio::awaitable<void> read() override;
  boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) override;
  void send_now(WriteQueue& queue) override;
  boost::asio::awaitable<void> finish_stream() override { co_return; }
  void close() noexcept override;
  std::size_t untaken_bytes() noexcept override;
  /// What else has arrived, up to `kReadBytes`.
  void read_more(LineReader& reader);
  void take_line(const LineReader::Line& line);

  Socket socket_;
};

}  // namespace hedgehog::server
