// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/websocket_connection.h"

#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/websocket.hpp>
#include <chrono>
#include <memory>
#include <string_view>
#include <utility>

#include "daemon/server/net/connection.h"
#include "daemon/server/net/socket_send_queue.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;
using boost::system::error_code;

constexpr std::chrono::seconds kHandshake{10};
/// A peer without a pong for this long is disconnected.
constexpr std::chrono::seconds kMaxPeerSilence{60};

class WebSocketConnection final : public Connection {
 public:
  using Stream = websocket::stream<HttpStream>;

  WebSocketConnection(Stream stream, Server& server, Session session,
                      const config::ConnectionSettings& settings)
      : Connection(stream.get_executor(), server, std::move(session), settings),
        stream_(std::move(stream)) {
    // Beast would report the end only after the client has closed its socket too.
    stream_.control_callback([this](websocket::frame_type kind, beast::string_view) {
      if (kind == websocket::frame_type::close) on_client_close();
    });
  }

 private:
  asio::awaitable<void> read() override;
  asio::awaitable<error_code> send_next(WriteQueue& queue) override;
  asio::awaitable<void> finish_stream() override;
  void close() noexcept override;
  std::size_t unread_bytes() noexcept override;
  /// Reads one whole message into `buffer_`; one that is too long is discarded. False: the client
  /// has closed, or must be disconnected.
  asio::awaitable<bool> read_message();

  Stream stream_;
  websocket::close_reason close_reason_{websocket::close_code::going_away};
  beast::flat_buffer buffer_;
  bool skipping_ = false;
  // Beast then continues to read by itself; a read that starts in the middle of a message which it
  // has skipped meanwhile would fail its assertions.
  bool closing_ = false;
};

asio::awaitable<bool> WebSocketConnection::read_message() {
  buffer_.clear();
  skipping_ = false;
  do {
    if (closing_) co_return false;
    error_code ec;
    co_await stream_.async_read_some(buffer_, Connection::kReadBytes,
                                     asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return false;
    if (skipping_) {
      buffer_.clear();
    } else if (buffer_.size() > protocol::kMaxLineBytes) {
      skipping_ = true;
      buffer_.clear();
      on_received();
      too_long();
      const bool stays = !must_pause() || co_await pause();
      end_turn();
      if (!stays) co_return false;
    }
  } while (!stream_.is_message_done());
  co_return true;
}

asio::awaitable<void> WebSocketConnection::read() {
  while (co_await read_message()) {
    if (stream_.got_binary()) {
      close_reason_ = {websocket::close_code::unknown_data, "send text frames"};
      co_return;
    }
    if (skipping_) continue;
    on_received();
    const asio::const_buffer bytes = buffer_.cdata();
    take({static_cast<const char*>(bytes.data()), bytes.size()});
    if (must_pause() && !co_await pause()) co_return;
    end_turn();
  }
}

asio::awaitable<error_code> WebSocketConnection::send_next(WriteQueue& queue) {
  std::string_view left = queue.take_one();
  left.remove_suffix(1);  // the LF
  error_code ec;
  while (!ec && !left.empty()) {
    const std::string_view part = left.substr(0, Connection::kReadBytes);
    left.remove_prefix(part.size());
    co_await stream_.async_write_some(left.empty(), asio::buffer(part),
                                      asio::redirect_error(asio::use_awaitable, ec));
    on_sent_part();
  }
  co_return ec;
}

std::size_t WebSocketConnection::unread_bytes() noexcept {
  return socket_send_queue(stream_.next_layer().socket().native_handle());
}

asio::awaitable<void> WebSocketConnection::finish_stream() {
  if (stream_.is_open()) {
    closing_ = true;
    error_code ignored;
    co_await stream_.async_close(close_reason_, asio::redirect_error(asio::use_awaitable, ignored));
  }
}

void WebSocketConnection::close() noexcept {
  error_code ignored;
  auto& socket = stream_.next_layer().socket();
  socket.shutdown(asio::ip::tcp::socket::shutdown_both, ignored);
  socket.close(ignored);
}

}  // namespace

asio::awaitable<void> become_web_socket(HttpStream stream, UpgradeRequest request, Session session,
                                        HttpEndpoint& endpoint, HalfOpen::Ticket given_ticket) {
  stream.expires_never();
  WebSocketConnection::Stream upgraded(std::move(stream));
  HalfOpen::Ticket ticket(std::move(given_ticket));  // released before its socket
  upgraded.set_option(websocket::stream_base::timeout{kHandshake, kMaxPeerSilence, true});
  // Beast would close the connection after a message that is too long; here it gets an error, as on
  // TCP.
  upgraded.read_message_max(0);
  upgraded.text(true);
  error_code ec;
  co_await upgraded.async_accept(request, asio::redirect_error(asio::use_awaitable, ec));
  if (ec) co_return;
  const auto connection = std::make_shared<WebSocketConnection>(
      std::move(upgraded), endpoint.server, std::move(session), endpoint.connections);
  if (connection->session().locked) connection->set_half_open(std::move(ticket));
  endpoint.enter(connection);
  connection->start();
}

}  // namespace hedgehog::server
