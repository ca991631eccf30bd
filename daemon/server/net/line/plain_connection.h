// SPDX-License-Identifier: MIT
// Lines on a plain socket, a system call per transfer: for first clients, and without io_uring.
#pragma once

#include <boost/asio/generic/stream_protocol.hpp>

#include "daemon/server/net/line/line_connection.h"

namespace hedgehog::server {

class PlainConnection final : public LineConnection {
 public:
  using Socket = boost::asio::generic::stream_protocol::socket;

  PlainConnection(Socket socket, Server& server, Session session,
                  const config::ConnectionSettings& settings);

 private:
  boost::asio::awaitable<void> read() override;
  boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) override;
  bool send_now(WriteQueue& queue, Flush when) override;
  boost::asio::awaitable<void> finish_stream() override { co_return; }
  void close() noexcept override;
  std::size_t unread_bytes() noexcept override;

  Socket socket_;
};

}  // namespace hedgehog::server
