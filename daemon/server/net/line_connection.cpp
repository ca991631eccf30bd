// SPDX-License-Identifier: MIT
#include "daemon/server/net/line_connection.h"

#include <spdlog/spdlog.h>

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <string_view>

#include "daemon/server/net/socket_send_queue.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

/// A TLS stream needs a buffer while it waits; it holds most of what arrives at a time.
constexpr std::size_t kTlsBytes = 2048;

}  // namespace

template <class Stream>
asio::awaitable<void> BasicLineConnection<Stream>::read() {
  LineReader reader(protocol::kMaxLineBytes);
  std::array<char, kPlain ? 0 : kTlsBytes> buffer;
  bool known = false;
  for (;;) {
    error_code ec;
    if constexpr (kPlain) {
      co_await stream_.async_wait(Socket::wait_read, asio::redirect_error(asio::use_awaitable, ec));
      if (ec) co_return;
      on_received();
      if (!read_available(reader)) co_return;
    } else {
      const std::size_t count = co_await stream_.async_read_some(
          asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
      if (ec) co_return;
      on_received();
      reader.feed({buffer.data(), count});
    }
    if (!known && reader.first_byte()) {
      known = true;
      // Web pages can reach loopback, and HTTP requests begin with a letter.
      if (*reader.first_byte() != '{' && *reader.first_byte() != '[') {
        spdlog::warn("connection {} does not speak JSON-RPC; closed", id());
        ++counters().rejected["not_json"];
        co_return;
      }
    }
    while (const auto line = reader.next()) {
      take_line(*line);
      if (must_pause() && !co_await pause()) co_return;
    }
    end_turn();
  }
}

template <class Stream>
bool BasicLineConnection<Stream>::read_available(LineReader& reader) {
  if constexpr (kPlain) {
    // Used by one connection at a time, never across a suspension.
    static std::array<char, kReadBytes> buffer;
    error_code ec;
    const std::size_t count = stream_.read_some(asio::buffer(buffer), ec);
    reader.feed({buffer.data(), count});
    return !ec || ec == asio::error::would_block;
  }
  return false;
}

template <class Stream>
void BasicLineConnection<Stream>::take_line(const LineReader::Line& line) {
  if (line.too_long)
    too_long();
  else
    take(line.text);
}

template <class Stream>
asio::awaitable<error_code> BasicLineConnection<Stream>::send_next(WriteQueue& queue) {
  if (!queue.is_sending()) queue.take();
  error_code ec;
  while (!ec && !queue.unsent().empty()) {
    queue.sent_part(co_await stream_.async_write_some(
        asio::buffer(queue.unsent()), asio::redirect_error(asio::use_awaitable, ec)));
    on_sent_part();
  }
  co_return ec;
}

template <class Stream>
void BasicLineConnection<Stream>::send_now(WriteQueue& queue) {
  if constexpr (kPlain) {
    error_code ec;
    while (queue.bytes() > 0) {
      if (!queue.is_sending()) queue.take();
      queue.sent_part(stream_.write_some(asio::buffer(queue.unsent()), ec));
      if (ec) return;
      on_sent_part();
      if (queue.unsent().empty()) queue.sent();
    }
  }
}

template <class Stream>
asio::awaitable<void> BasicLineConnection<Stream>::finish_stream() {
  if constexpr (!kPlain) {
    // So that the client can detect that nothing is missing.
    error_code ignored;
    co_await stream_.async_shutdown(asio::redirect_error(asio::use_awaitable, ignored));
  }
  co_return;
}

template <class Stream>
void BasicLineConnection<Stream>::close() noexcept {
  error_code ignored;
  stream_.lowest_layer().shutdown(Socket::shutdown_both, ignored);
  stream_.lowest_layer().close(ignored);
}

template <class Stream>
std::size_t BasicLineConnection<Stream>::unread_bytes() noexcept {
  return socket_send_queue(stream_.lowest_layer().native_handle());
}

template class BasicLineConnection<asio::generic::stream_protocol::socket>;
template class BasicLineConnection<TlsStream>;

}  // namespace hedgehog::server
