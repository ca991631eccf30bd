// SPDX-License-Identifier: MIT
// A client on TCP, with TLS or without, or on the Unix socket: one message per line.
#pragma once

#include <boost/asio/buffer.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <string_view>

#include "daemon/server/net/connection.h"
#include "daemon/server/net/line/line_reader.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {

class LineConnection : public Connection {
 protected:
  using Connection::Connection;

  /// Appends what was received. False: the client does not speak this protocol, and must be
  /// disconnected. REQUIRES: `take_lines` has returned false since the last `feed`.
  bool feed(std::string_view bytes);
  /// Takes the complete lines. True: `pause`, and call it again.
  bool take_lines();
  /// `send_next` for a stream of Asio.
  template <class Stream>
  boost::asio::awaitable<boost::system::error_code> send_to(Stream& stream, WriteQueue& queue);

  /// `send_now` by `write_some`, which returns the bytes that the socket has taken; <= 0: none.
  template <class WriteSome>
  bool send_by(WriteQueue& queue, WriteSome write_some);

 private:
  LineReader reader_{protocol::kMaxLineBytes};
  bool known_ = false;
};

template <class Stream>
boost::asio::awaitable<boost::system::error_code> LineConnection::send_to(Stream& stream,
                                                                          WriteQueue& queue) {
  namespace asio = boost::asio;
  if (!queue.is_sending()) queue.take();
  boost::system::error_code ec;
  while (!ec && !queue.unsent().empty()) {
    queue.sent_part(co_await stream.async_write_some(
        asio::buffer(queue.unsent()), asio::redirect_error(asio::use_awaitable, ec)));
    on_sent_part();
  }
  co_return ec;
}

template <class WriteSome>
bool LineConnection::send_by(WriteQueue& queue, WriteSome write_some) {
  while (queue.bytes() > 0) {
    if (!queue.is_sending()) queue.take();
    const auto count = write_some(queue.unsent());
    if (count <= 0) return false;
    queue.sent_part(static_cast<std::size_t>(count));
    on_sent_part();
    if (queue.unsent().empty()) queue.sent();
  }
  return true;
}

}  // namespace hedgehog::server
