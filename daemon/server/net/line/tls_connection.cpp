// SPDX-License-Identifier: MIT
#include "daemon/server/net/line/tls_connection.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <utility>

#include "daemon/server/net/socket_send_queue.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

/// A TLS stream needs a buffer while it waits; it holds most of what arrives at a time.
constexpr std::size_t kTlsBytes = 2048;

}  // namespace

TlsConnection::TlsConnection(Stream stream, Server& server, Session session,
                             const config::ConnectionSettings& settings)
    : LineConnection(stream.get_executor(), server, std::move(session), settings),
      stream_(std::move(stream)) {}

asio::awaitable<void> TlsConnection::read() {
  std::array<char, kTlsBytes> buffer;
  for (;;) {
    error_code ec;
    const std::size_t count = co_await stream_.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return;
    on_received();
    if (!feed({buffer.data(), count})) co_return;
    while (take_lines())
      if (!co_await pause()) co_return;
    end_turn();
  }
}

asio::awaitable<error_code> TlsConnection::send_next(WriteQueue& queue) {
  return send_to(stream_, queue);
}

asio::awaitable<void> TlsConnection::finish_stream() {
  // So that the client can detect that nothing is missing.
  error_code ignored;
  co_await stream_.async_shutdown(asio::redirect_error(asio::use_awaitable, ignored));
}

void TlsConnection::close() noexcept {
  error_code ignored;
  stream_.lowest_layer().shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
  stream_.lowest_layer().close(ignored);
}

std::size_t TlsConnection::unread_bytes() noexcept {
  return socket_send_queue(stream_.lowest_layer().native_handle());
}

}  // namespace hedgehog::server
