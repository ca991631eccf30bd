// SPDX-License-Identifier: MIT
#include "daemon/server/net/line_connection.h"

#include <spdlog/spdlog.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <string_view>

#include "daemon/server/net/socket_send_queue.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

}  // namespace

asio::awaitable<bool> LineConnection::take_lines(LineReader& reader) {
  while (const auto line = reader.next()) {
    const bool stays = line->too_long ? co_await too_long() : co_await take(line->text);
    if (!stays) co_return false;
  }
  co_return true;
}

asio::awaitable<void> LineConnection::read() {
  LineReader reader(protocol::kMaxLineBytes);
  std::array<char, kReadBytes> buffer;
  bool known = false;
  for (;;) {
    error_code ec;
    const std::size_t count = co_await socket_.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return;
    begin_turn();
    reader.feed({buffer.data(), count});
    if (!known && reader.first_byte()) {
      known = true;
      // Web pages can reach loopback, and what a browser sends begins with a letter.
      if (*reader.first_byte() != '{' && *reader.first_byte() != '[') {
        spdlog::warn("connection {} does not speak JSON-RPC; closed", id());
        ++counters().rejected["not_json"];
        co_return;
      }
    }
    if (!co_await take_lines(reader)) co_return;
  }
}

asio::awaitable<error_code> LineConnection::send_next(WriteQueue& queue) {
  std::string_view left = queue.take();
  error_code ec;
  while (!ec && !left.empty()) {
    left.remove_prefix(co_await socket_.async_write_some(
        asio::buffer(left), asio::redirect_error(asio::use_awaitable, ec)));
    on_sent_part();
  }
  co_return ec;
}

void LineConnection::close() noexcept {
  error_code ignored;
  socket_.shutdown(Socket::shutdown_both, ignored);
  socket_.close(ignored);
}

std::size_t LineConnection::untaken_bytes() noexcept {
  return socket_send_queue(socket_.native_handle());
}

}  // namespace hedgehog::server
