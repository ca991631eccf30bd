// SPDX-License-Identifier: MIT
#include "daemon/server/net/line/plain_connection.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <string_view>
#include <utility>

#include "daemon/server/net/socket_send_queue.h"

namespace hedgehog::server {

namespace asio = boost::asio;
using boost::system::error_code;

PlainConnection::PlainConnection(Socket socket, Server& server, Session session,
                                 const config::ConnectionSettings& settings)
    : LineConnection(socket.get_executor(), server, std::move(session), settings),
      socket_(std::move(socket)) {
  // For `read_some` and `write_some`; asynchronous operations are not affected.
  error_code ignored;
  socket_.non_blocking(true, ignored);
}

asio::awaitable<void> PlainConnection::read() {
  // Used by one connection at a time, never across a suspension.
  static std::array<char, kReadBytes> buffer;
  error_code ec;
  do {
    // Without a buffer of its own.
    co_await socket_.async_wait(Socket::wait_read, asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return;
    on_received();
    const std::size_t count = socket_.read_some(asio::buffer(buffer), ec);
    if (!feed({buffer.data(), count})) co_return;
    while (take_lines())
      if (!co_await pause()) co_return;
    end_turn();
  } while (!ec || ec == asio::error::would_block);
}

asio::awaitable<error_code> PlainConnection::send_next(WriteQueue& queue) {
  return send_to(socket_, queue);
}

bool PlainConnection::send_now(WriteQueue& queue, Flush) {
  return send_by(
      queue,
      [this](std::string_view bytes) {
        error_code ec;
        return static_cast<ssize_t>(socket_.write_some(asio::buffer(bytes), ec));
      });
}

void PlainConnection::close() noexcept {
  error_code ignored;
  socket_.shutdown(Socket::shutdown_both, ignored);
  socket_.close(ignored);
}

std::size_t PlainConnection::unread_bytes() noexcept {
  return socket_send_queue(socket_.native_handle());
}

}  // namespace hedgehog::server
