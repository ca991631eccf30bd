// SPDX-License-Identifier: MIT
#include "daemon/server/net/line/ring_connection.h"

#include <fcntl.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <boost/asio/post.hpp>
#include <utility>

#include "daemon/server/net/socket_send_queue.h"

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;

/// More is sent by a system call of its own: so much does not wait for others.
constexpr std::size_t kTogetherBytes = 4096;

}  // namespace

template <class Start>
asio::awaitable<RingConnection::Awaited::Result> RingConnection::Awaited::run(Start start) {
  return asio::async_initiate<const Token, void(Result)>(
      [this, start](Handler handler) {
        handler_.emplace(std::move(handler));
        start();
      },
      asio::use_awaitable);
}

void RingConnection::Awaited::complete(int result, std::string_view data) {
  Handler handler = std::move(*handler_);
  handler_.reset();
  handler(Result{result, data});
}

void RingConnection::Awaited::drop() noexcept {
  // Its coroutine is destroyed by the io_context, at the latest with it.
  const std::optional<Handler> handler = std::exchange(handler_, std::nullopt);
}

void RingConnection::Immediate::start(std::string_view bytes) {
  kept_ = connection_.shared_from_this();
  connection_.ring_.send_now(connection_.socket_, bytes, *this);
}

bool RingConnection::Immediate::finish() {
  // A completed one may be followed by the next.
  while (is_pending())
    if (connection_.ring_.withdraw(*this))
      kept_.reset();
    else if (!connection_.ring_.settle(*this))
      return false;
  return true;
}

void RingConnection::Immediate::complete(int result, std::string_view) {
  const std::shared_ptr<Connection> kept = std::move(kept_);
  connection_.sent_now(static_cast<std::size_t>(std::max(result, 0)));
}

RingConnection::RingConnection(Socket socket, Ring& ring, Server& server, Session session,
                               const config::ConnectionSettings& settings)
    : LineConnection(socket.get_executor(), server, std::move(session), settings),
      ring_(ring),
      socket_(socket.release()) {
  // A receive of a socket that does not block would not wait.
  fcntl(socket_, F_SETFL, fcntl(socket_, F_GETFL) & ~O_NONBLOCK);
}

RingConnection::~RingConnection() {
  close_socket();
  ::close(socket_);
}

asio::awaitable<void> RingConnection::read() {
  for (;;) {
    const auto [count, data] = co_await receive_.run([this] { ring_.receive(socket_, receive_); });
    // What had arrived before the socket was closed is still received.
    if (count <= 0 || closed_) co_return;
    on_received();
    if (!feed(data)) co_return;
    while (take_lines())
      if (!co_await pause()) co_return;
    end_turn();
  }
}

asio::awaitable<error_code> RingConnection::send_next(WriteQueue& queue) {
  // What `send_now` has started is continued here.
  while (!send_now_.finish()) co_await asio::post(executor(), asio::use_awaitable);
  if (!queue.is_sending() && !queue.empty()) queue.take();
  while (!queue.unsent().empty()) {
    const auto result = co_await send_.run([&] { ring_.send(socket_, queue.unsent(), send_); });
    if (result.count < 0) co_return error_code(-result.count, boost::system::system_category());
    queue.sent_part(static_cast<std::size_t>(result.count));
    on_sent_part();
  }
  co_return error_code{};
}

bool RingConnection::send_now(WriteQueue& queue, Flush when) {
  if (when == Flush::kSoon && queue.bytes() <= kTogetherBytes) {
    if (send_now_.is_pending()) return true;
    if (!queue.is_sending()) queue.take();
    send_now_.start(queue.unsent());
    return true;
  }
  if (!send_now_.finish()) return true;
  return send_by(queue, [this](std::string_view bytes) {
    return ::send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
  });
}

void RingConnection::close() noexcept {
  closed_ = true;
  ::shutdown(socket_, SHUT_RDWR);
}

std::size_t RingConnection::unread_bytes() noexcept { return socket_send_queue(socket_); }

}  // namespace hedgehog::server
