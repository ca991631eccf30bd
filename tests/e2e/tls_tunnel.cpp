// SPDX-License-Identifier: MIT
#include "tests/e2e/tls_tunnel.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <memory>
#include <thread>

namespace hedgehog::e2e {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

struct Pair {
  Tcp::socket client;
  asio::ssl::stream<Tcp::socket> daemon;

  void close() {
    error_code ignored;
    client.close(ignored);
    daemon.lowest_layer().close(ignored);
  }
};

/// Copies from `from` to `to`; calls `end` at the end.
template <class From, class To, class End>
asio::awaitable<void> copy(std::shared_ptr<Pair> pair, From& from, To& to, End end) {
  std::array<char, 16 * 1024> buffer;
  error_code ec;
  while (!ec) {
    const std::size_t count = co_await from.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) break;
    co_await asio::async_write(to, asio::buffer(buffer, count),
                               asio::redirect_error(asio::use_awaitable, ec));
  }
  co_await end(*pair);
}

asio::awaitable<void> shut_daemon(Pair& pair) {
  error_code ignored;
  co_await pair.daemon.async_shutdown(asio::redirect_error(asio::use_awaitable, ignored));
}

asio::awaitable<void> shut_all(Pair& pair) {
  pair.close();
  co_return;
}

}  // namespace

struct TlsTunnel::Impl {
  asio::io_context io{1};
  asio::ssl::context context{asio::ssl::context::tls_client};
  Tcp::acceptor acceptor{io, Tcp::endpoint(asio::ip::address_v4::loopback(), 0)};
  Tcp::endpoint to;
  std::thread thread;

  asio::awaitable<void> accept() {
    for (;;) {
      error_code ec;
      auto pair = std::make_shared<Pair>(
          Pair{co_await acceptor.async_accept(asio::use_awaitable), {Tcp::socket(io), context}});
      co_await pair->daemon.next_layer().async_connect(
          to, asio::redirect_error(asio::use_awaitable, ec));
      if (!ec)
        co_await pair->daemon.async_handshake(asio::ssl::stream_base::client,
                                              asio::redirect_error(asio::use_awaitable, ec));
      if (ec) {
        pair->close();
        continue;
      }
      asio::co_spawn(io, copy(pair, pair->client, pair->daemon, shut_daemon), asio::detached);
      asio::co_spawn(io, copy(pair, pair->daemon, pair->client, shut_all), asio::detached);
    }
  }
};

TlsTunnel::TlsTunnel(int to) : impl_(std::make_unique<Impl>()) {
  impl_->to = {asio::ip::address_v4::loopback(), static_cast<unsigned short>(to)};
  asio::co_spawn(impl_->io, impl_->accept(), asio::detached);
  impl_->thread = std::thread([this] { impl_->io.run(); });
}

TlsTunnel::~TlsTunnel() {
  impl_->io.stop();
  impl_->thread.join();
}

int TlsTunnel::port() const noexcept { return impl_->acceptor.local_endpoint().port(); }

}  // namespace hedgehog::e2e
