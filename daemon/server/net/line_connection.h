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

  LineConnection(Socket socket, Server& server, Session session, std::size_t queue_bytes)
      : Connection(socket.get_executor(), server, std::move(session), queue_bytes),
        socket_(std::move(socket)) {}

 private:
  boost::asio::awaitable<void> read() override;
  boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) override;
  boost::asio::awaitable<void> finish_stream() override { co_return; }
  void close() noexcept override;
  boost::asio::awaitable<bool> take_lines(LineReader& reader);

  Socket socket_;
};

}  // namespace hedgehog::server
