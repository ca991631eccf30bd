// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/http_stream.h"

#include <boost/asio/error.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/beast/ssl/ssl_stream.hpp>
#include <memory>
#include <utility>

#include "daemon/server/net/connection.h"

namespace hedgehog::server {

namespace asio = boost::asio;
namespace beast = boost::beast;
using asio::ip::tcp;
using boost::system::error_code;

namespace {

asio::awaitable<error_code> end_tcp(beast::tcp_stream& stream) {
  error_code ec;
  stream.socket().shutdown(tcp::socket::shutdown_send, ec);
  const auto sink = std::make_unique<std::array<char, Connection::kReadBytes>>();
  while (!ec) {
    co_await stream.async_read_some(asio::buffer(*sink),
                                    asio::redirect_error(asio::use_awaitable, ec));
  }
  co_return ec == asio::error::eof ? error_code() : ec;
}

}  // namespace

struct HttpStream::PlainTransport final : HttpStream::Transport {
  explicit PlainTransport(tcp::socket socket) : stream(std::move(socket)) {}

  beast::tcp_stream& tcp() noexcept override { return stream; }
  void read(asio::mutable_buffer buffer, TransferHandler handler) override {
    stream.async_read_some(buffer, std::move(handler));
  }
  void write(const Gathered& buffers, TransferHandler handler) override {
    stream.async_write_some(buffers, std::move(handler));
  }
  asio::awaitable<error_code> handshake() override { co_return error_code(); }
  asio::awaitable<error_code> end() override { return end_tcp(stream); }

  beast::tcp_stream stream;
};

struct HttpStream::TlsTransport final : HttpStream::Transport {
  TlsTransport(tcp::socket socket, TlsContext given)
      : context(std::move(given)), stream(beast::tcp_stream(std::move(socket)), *context) {}

  beast::tcp_stream& tcp() noexcept override { return stream.next_layer(); }
  void read(asio::mutable_buffer buffer, TransferHandler handler) override {
    stream.async_read_some(buffer, std::move(handler));
  }
  void write(const Gathered& buffers, TransferHandler handler) override {
    stream.async_write_some(buffers, std::move(handler));
  }
  asio::awaitable<error_code> handshake() override {
    error_code ec;
    co_await stream.async_handshake(asio::ssl::stream_base::server,
                                    asio::redirect_error(asio::use_awaitable, ec));
    co_return ec;
  }
  asio::awaitable<error_code> end() override {
    error_code ec;
    co_await stream.async_shutdown(asio::redirect_error(asio::use_awaitable, ec));
    // For a client that still sends.
    if (ec) co_await end_tcp(stream.next_layer());
    co_return ec;
  }

  TlsContext context;
  beast::ssl_stream<beast::tcp_stream> stream;
};

HttpStream::HttpStream(tcp::socket socket)
    : transport_(std::make_unique<PlainTransport>(std::move(socket))), tls_(false) {}

HttpStream::HttpStream(tcp::socket socket, const TlsContext& context)
    : transport_(std::make_unique<TlsTransport>(std::move(socket), context)), tls_(true) {}

void beast_close_socket(HttpStream& stream) {
  error_code ignored;
  stream.socket().close(ignored);
}

}  // namespace hedgehog::server
