// SPDX-License-Identifier: MIT
#include "clients/ctl/tunnel/ball_stream.h"

#include <netinet/tcp.h>
#include <sys/socket.h>

#include <boost/asio/buffer.hpp>
#include <boost/asio/error.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/read_until.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/this_coro.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <string_view>
#include <variant>

#include "clients/lib/response_timeout.h"
#include "protocol/client_codec.h"

namespace hedgehog::client {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

constexpr std::size_t kMaxHelloResponse = 65'536;
// Without traffic the network is probed after 5 s, and again after 5 s; with it, unacknowledged
// bytes count. Otherwise a game would play on for minutes into a network that is lost.
constexpr int kProbeS = 5;
constexpr int kProbes = 2;
constexpr int kLostMs = 15'000;

void set_option(TlsStream::Socket& socket, int level, int name, int value) {
  ::setsockopt(socket.native_handle(), level, name, &value, sizeof value);
}

void set_options(TlsStream::Socket& socket) {
  set_option(socket, IPPROTO_TCP, TCP_NODELAY, 1);
  set_option(socket, SOL_SOCKET, SO_KEEPALIVE, 1);
  set_option(socket, IPPROTO_TCP, TCP_KEEPIDLE, kProbeS);
  set_option(socket, IPPROTO_TCP, TCP_KEEPINTVL, kProbeS);
  set_option(socket, IPPROTO_TCP, TCP_KEEPCNT, kProbes);
  set_option(socket, IPPROTO_TCP, TCP_USER_TIMEOUT, kLostMs);
}

ClientError no_response(const Address& address, const std::string& why) {
  return {Failure::kNoDaemon, "no daemon answers at " + to_string(address) + " (" + why + ")", {}};
}

/// The daemon's answer to the hello.
Outcome<void> hello_outcome(std::string_view line) {
  const auto messages = protocol::decode_messages(line);
  if (!messages) return ClientError{Failure::kProtocol, messages.error().message, {}};
  const auto* reply =
      messages->size() == 1 ? std::get_if<protocol::Reply>(&messages->front()) : nullptr;
  if (reply == nullptr) return ClientError{Failure::kProtocol, "it does not answer a hello", {}};
  if (reply->result) return {};
  const protocol::RpcError& refusal = reply->result.error();
  return ClientError{Failure::kRefused, refusal.message, refusal};
}

}  // namespace

BallStream::BallStream(const asio::any_io_executor& executor, const Address& address)
    : address_(address), socket_(executor), tls_(socket_, address), deadline_(executor) {}

asio::awaitable<BallStream::Opened> BallStream::open(const std::vector<Address>& addresses) {
  const auto executor = co_await asio::this_coro::executor;
  ClientError problem{Failure::kNoDaemon, "there is no address", {}};
  for (const Address& address : addresses) {
    error_code ec;
    Tcp::resolver resolver(executor);
    const auto endpoints = co_await resolver.async_resolve(
        address.host, std::to_string(address.port), asio::redirect_error(asio::use_awaitable, ec));
    if (ec) problem = no_response(address, reason_of(ec));
    for (const auto& entry : endpoints) {
      auto ball = std::make_shared<BallStream>(executor, address);
      const Endpoint endpoint(entry.endpoint());
      const auto opened = co_await ball->connect_and_log_in(endpoint);
      if (opened) co_return ball;
      problem = opened.error();
      if (problem.failure != Failure::kNoDaemon) co_return problem;
    }
  }
  co_return problem;
}

asio::awaitable<Outcome<void>> BallStream::connect_and_log_in(const Endpoint& endpoint) {
  deadline_.start(response_timeout(), [self = shared_from_this()] {
    self->timed_out_ = true;
    self->close();
  });
  const std::string why = co_await connect(endpoint);
  Outcome<void> outcome;
  if (!why.empty())
    outcome = no_response(address_, why);
  else if (address_.token)
    outcome = co_await log_in();
  deadline_.stop();
  // It may have expired just before; then the connection is closed.
  if (outcome && timed_out_) outcome = no_response(address_, reason_of_end({}));
  co_return outcome;
}

asio::awaitable<std::string> BallStream::connect(const Endpoint& endpoint) {
  error_code ec;
  co_await socket_.async_connect(endpoint, asio::redirect_error(asio::use_awaitable, ec));
  if (ec) co_return reason_of_end(ec);
  set_options(socket_);
  co_await tls_.async_handshake(asio::redirect_error(asio::use_awaitable, ec));
  if (ec) co_return "TLS: " + reason_of_end(ec);
  co_return tls_.verify_problem();
}

asio::awaitable<Outcome<void>> BallStream::log_in() {
  const protocol::Hello hello{"hedgehogctl tunnel", "1.0", address_.token};
  const std::string line = protocol::encode_request(protocol::Id::number(1), hello) + "\n";
  std::string response;
  std::size_t size = 0;
  error_code ec;
  co_await asio::async_write(stream(), asio::buffer(line),
                             asio::redirect_error(asio::use_awaitable, ec));
  if (!ec)
    size =
        co_await asio::async_read_until(stream(), asio::dynamic_buffer(response, kMaxHelloResponse),
                                        '\n', asio::redirect_error(asio::use_awaitable, ec));
  if (ec) co_return no_response(address_, reason_of_end(ec));
  // The daemon sends nothing but responses until it is asked to, so nothing follows this line.
  co_return hello_outcome(std::string_view(response).substr(0, size - 1));
}

std::string BallStream::reason_of_end(const error_code& error) const {
  return reason_of(timed_out_ ? asio::error::timed_out : error);
}

void BallStream::end_requests() noexcept {
  error_code ignored;
  socket_.shutdown(TlsStream::Socket::shutdown_send, ignored);
}

void BallStream::close() noexcept {
  error_code ignored;
  socket_.shutdown(TlsStream::Socket::shutdown_both, ignored);
  socket_.close(ignored);
}

}  // namespace hedgehog::client
