// SPDX-License-Identifier: MIT
#include "clients/ctl/tunnel/relay.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <string_view>
#include <utility>

#include "clients/lib/response_timeout.h"

namespace hedgehog::client {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

constexpr std::size_t kRelayBytes = 16 * 1024;

struct Pair {
  Tcp::socket client;
  std::shared_ptr<BallStream> ball;
  asio::steady_timer last_responses;

  void close() noexcept {
    error_code ignored;
    client.close(ignored);
    ball->close();
    last_responses.cancel();
  }
};

/// Until `from` ends or `to` is closed.
template <class From, class To>
asio::awaitable<void> copy_bytes(From& from, To& to) {
  std::array<char, kRelayBytes> buffer;
  error_code ec;
  while (!ec) {
    const std::size_t count = co_await from.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (!ec)
      co_await asio::async_write(to, asio::buffer(buffer, count),
                                 asio::redirect_error(asio::use_awaitable, ec));
  }
}

asio::awaitable<void> copy_requests(std::shared_ptr<Pair> pair, std::string first) {
  error_code ec;
  co_await asio::async_write(pair->ball->stream(), asio::buffer(first),
                             asio::redirect_error(asio::use_awaitable, ec));
  if (!ec) co_await copy_bytes(pair->client, pair->ball->stream());
  if (!pair->client.is_open()) co_return;
  pair->ball->end_requests();
  pair->last_responses.expires_after(response_timeout());
  co_await pair->last_responses.async_wait(asio::redirect_error(asio::use_awaitable, ec));
  if (!ec) pair->close();
}

}  // namespace

asio::awaitable<std::string> first_bytes(Tcp::socket& client) {
  std::array<char, kRelayBytes> buffer;
  for (;;) {
    error_code ec;
    const std::size_t count = co_await client.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return std::string();
    const std::string_view bytes(buffer.data(), count);
    const std::size_t begin = bytes.find_first_not_of("\r\n");
    if (begin == std::string_view::npos) continue;
    if (bytes[begin] != '{' && bytes[begin] != '[') co_return std::string();
    co_return std::string(bytes.substr(begin));
  }
}

asio::awaitable<void> relay(Tcp::socket client, std::shared_ptr<BallStream> ball,
                            std::string first) {
  const auto executor = client.get_executor();
  const auto pair = std::make_shared<Pair>(
      Pair{std::move(client), std::move(ball), asio::steady_timer(executor)});
  asio::co_spawn(executor, copy_requests(pair, std::move(first)), asio::detached);
  co_await copy_bytes(pair->ball->stream(), pair->client);
  pair->close();
}

}  // namespace hedgehog::client
