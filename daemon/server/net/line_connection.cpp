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

/// Each connection that waits has a buffer of this size: of what arrives at once, it takes most.
constexpr std::size_t kWaitBytes = 2048;

}  // namespace

asio::awaitable<void> LineConnection::read() {
  LineReader reader(protocol::kMaxLineBytes);
  std::array<char, kWaitBytes> buffer;
  bool known = false;
  for (;;) {
    error_code ec;
    const std::size_t count = co_await socket_.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return;
    on_received();
    reader.feed({buffer.data(), count});
    if (count == buffer.size()) read_more(reader);
    if (!known && reader.first_byte()) {
      known = true;
      // Web pages can reach loopback, and what a browser sends begins with a letter.
      if (*reader.first_byte() != '{' && *reader.first_byte() != '[') {
        spdlog::warn("connection {} does not speak JSON-RPC; closed", id());
        ++counters().rejected["not_json"];
        co_return;
      }
    }
    while (const auto line = reader.next()) {
      take_line(*line);
      if (has_to_pause() && !co_await pause()) co_return;
    }
    end_turn();
  }
}

void LineConnection::read_more(LineReader& reader) {
  // Used by one connection at a time, never across a wait.
  static std::array<char, kReadBytes> buffer;
  error_code ec;
  // An end or an error is met by the next read.
  const std::size_t count = socket_.read_some(asio::buffer(buffer), ec);
  if (!ec) reader.append({buffer.data(), count});
}

void LineConnection::take_line(const LineReader::Line& line) {
  if (line.too_long)
    too_long();
  else
    take(line.text);
}

asio::awaitable<error_code> LineConnection::send_next(WriteQueue& queue) {
  if (!queue.is_sending()) queue.take();
  error_code ec;
  while (!ec && !queue.unsent().empty()) {
    queue.sent_part(co_await socket_.async_write_some(
        asio::buffer(queue.unsent()), asio::redirect_error(asio::use_awaitable, ec)));
    on_sent_part();
  }
  co_return ec;
}

void LineConnection::send_now(WriteQueue& queue) {
  error_code ec;
  while (queue.bytes() > 0) {
    if (!queue.is_sending()) queue.take();
    queue.sent_part(socket_.write_some(asio::buffer(queue.unsent()), ec));
    if (ec) return;
    on_sent_part();
    if (queue.unsent().empty()) queue.sent();
  }
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
