// SPDX-License-Identifier: MIT
#include "clients/ctl/tunnel/relay.h"

#include <array>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <string_view>
#include <utility>

#include "clients/ctl/tunnel/coroutine.h"
#include "clients/ctl/tunnel/deadline.h"
#include "clients/lib/response_timeout.h"

namespace hedgehog::client {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

constexpr std::size_t kRelayBytes = 16 * 1024;

struct Pair : std::enable_shared_from_this<Pair> {
  Pair(Tcp::socket from, std::shared_ptr<BallStream> to, std::chrono::milliseconds time)
      : client(std::move(from)), ball(std::move(to)), write_time(time) {}

  Tcp::socket client;
  std::shared_ptr<BallStream> ball;
  std::chrono::milliseconds write_time;
  Deadline last_responses{client.get_executor()};

  void close() noexcept {
    error_code ignored;
    client.close(ignored);
    ball->close();
    last_responses.stop();
  }
  void close_after(Deadline& deadline, std::chrono::milliseconds time) {
    deadline.start(
        time, [self = shared_from_this()] { self->close(); });
  }
};

/// Sends `first` and then what `from` sends, until it ends, or `to` is closed or does not accept.
template <class From, class To>
asio::awaitable<void> copy_bytes(Pair& pair, From& from, To& to, std::string_view first = {}) {
  std::array<char, kRelayBytes> buffer;
  Deadline deadline(pair.client.get_executor());
  auto bytes = asio::buffer(first);
  for (error_code ec;;) {
    pair.close_after(deadline, pair.write_time);
    co_await asio::async_write(to, bytes, asio::redirect_error(asio::use_awaitable, ec));
    deadline.stop();
    if (ec) co_return;
    const std::size_t count = co_await from.async_read_some(
        asio::buffer(buffer), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) co_return;
    bytes = asio::buffer(std::string_view(buffer.data(), count));
  }
}

asio::awaitable<void> copy_requests(std::shared_ptr<Pair> pair, std::string first) {
  co_await copy_bytes(*pair, pair->client, pair->ball->stream(), first);
  if (!pair->client.is_open()) co_return;
  pair->ball->end_requests();
  pair->close_after(pair->last_responses, response_timeout());
}

}  // namespace

asio::awaitable<std::string> first_bytes(Tcp::socket& client, std::chrono::milliseconds time) {
  std::array<char, kRelayBytes> buffer;
  Deadline deadline(client.get_executor());
  deadline.start(time, [&client] {
    error_code ignored;
    client.close(ignored);
  });
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

asio::awaitable<void> relay(Tcp::socket client, std::shared_ptr<BallStream> ball, std::string first,
                            std::chrono::milliseconds write_time) {
  const auto pair = std::make_shared<Pair>(std::move(client), std::move(ball), write_time);
  spawn(pair->client.get_executor(), copy_requests(pair, std::move(first)));
  co_await copy_bytes(*pair, pair->ball->stream(), pair->client);
  pair->close();
}

}  // namespace hedgehog::client
