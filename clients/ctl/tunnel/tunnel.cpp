// SPDX-License-Identifier: MIT
#include "clients/ctl/tunnel/tunnel.h"

#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/signal_set.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <csignal>
#include <set>
#include <string>
#include <utility>

#include "clients/common/exit_code.h"
#include "clients/common/interrupts.h"
#include "clients/ctl/tunnel/ball_stream.h"
#include "clients/ctl/tunnel/coroutine.h"
#include "clients/ctl/tunnel/located_ball.h"
#include "clients/ctl/tunnel/relay.h"
#include "protocol/server_codec.h"

namespace hedgehog::client {
namespace {

namespace asio = boost::asio;
using boost::system::error_code;
using Tcp = asio::ip::tcp;

constexpr std::chrono::milliseconds kAcceptPause{100};
constexpr std::int64_t kRetryMs = 1000;

/// As the error without an id that a client receives.
protocol::RpcError notice_of(const ClientError& problem) {
  if (problem.refusal) return *problem.refusal;
  auto notice = protocol::error(protocol::ErrorCode::kBusy, "tunnel: " + problem.message);
  notice.retry_after_ms = kRetryMs;
  return notice;
}

asio::awaitable<void> send_notice(Tcp::socket& client, const ClientError& problem) {
  const std::string line = protocol::encode_error({}, notice_of(problem)) + "\n";
  error_code ignored;
  co_await asio::async_write(client, asio::buffer(line),
                             asio::redirect_error(asio::use_awaitable, ignored));
}

/// One of the clients, while it exists.
class Place {
 public:
  explicit Place(int& count) : count_(count) { ++count_; }
  Place(const Place&) = delete;
  Place& operator=(const Place&) = delete;
  ~Place() { --count_; }

 private:
  int& count_;
};

}  // namespace

struct Tunnel::Impl {
  Impl(std::vector<Address> to, Report with, const Limits& at_most)
      : report(std::move(with)), limits(at_most), ball(std::move(to)) {}

  const Report report;
  const Limits limits;
  std::set<std::string> reported;  // since a client has reached the ball
  int clients = 0;
  // Destroyed before what the coroutines in it refer to.
  asio::io_context io{1};
  LocatedBall ball;
  Tcp::acceptor acceptor{io};
  asio::signal_set signals{io, SIGINT, SIGTERM, SIGHUP};

  asio::awaitable<void> accept();
  asio::awaitable<void> serve(Tcp::socket client);
  asio::awaitable<void> refuse(Tcp::socket& client, const ClientError& problem);
  void report_once(const ClientError& problem);
};

asio::awaitable<void> Tunnel::Impl::accept() {
  asio::steady_timer pause(io);
  for (;;) {
    error_code ec;
    Tcp::socket client =
        co_await acceptor.async_accept(asio::redirect_error(asio::use_awaitable, ec));
    if (!ec) {
      spawn(io, serve(std::move(client)));
      continue;
    }
    // No descriptors are left.
    report_once({Failure::kClosed, "no further client is accepted: " + reason_of(ec), {}});
    pause.expires_after(kAcceptPause);
    co_await pause.async_wait(asio::use_awaitable);
  }
}

asio::awaitable<void> Tunnel::Impl::serve(Tcp::socket client) {
  const Place place(clients);
  if (clients > limits.clients) {
    const ClientError full{
        Failure::kClosed, "there are " + std::to_string(limits.clients) + " clients already", {}};
    co_await refuse(client, full);
    co_return;
  }
  error_code ignored;
  client.set_option(Tcp::no_delay(true), ignored);
  std::string first = co_await first_bytes(client, limits.first_request);
  if (first.empty()) co_return;
  auto stream = co_await ball.open();
  if (!stream) {
    co_await refuse(client, stream.error());
    co_return;
  }
  reported.clear();
  co_await relay(std::move(client), *std::move(stream), std::move(first), limits.write);
}

void Tunnel::Impl::report_once(const ClientError& problem) {
  if (reported.insert(problem.message).second) report(problem);
}

asio::awaitable<void> Tunnel::Impl::refuse(Tcp::socket& client, const ClientError& problem) {
  report_once(problem);
  co_await send_notice(client, problem);
}

Tunnel::Tunnel(std::vector<Address> addresses, Report report)
    : Tunnel(std::move(addresses), std::move(report), Limits()) {}

Tunnel::Tunnel(std::vector<Address> addresses, Report report, const Limits& limits)
    : impl_(std::make_unique<Impl>(std::move(addresses), std::move(report), limits)) {}

Tunnel::~Tunnel() = default;

Result<std::uint16_t> Tunnel::listen(std::uint16_t port) {
  // No other address is possible: other machines must not reach the ball with this one's token.
  const Tcp::endpoint endpoint(asio::ip::address_v4::loopback(), port);
  Tcp::acceptor& acceptor = impl_->acceptor;
  error_code ec;
  acceptor.open(endpoint.protocol(), ec);
  if (!ec) acceptor.set_option(Tcp::acceptor::reuse_address(true), ec);
  if (!ec) acceptor.bind(endpoint, ec);
  if (!ec) acceptor.listen(asio::socket_base::max_listen_connections, ec);
  const Tcp::endpoint bound = ec ? endpoint : acceptor.local_endpoint(ec);
  if (!ec) return bound.port();
  std::string message = "127.0.0.1:" + std::to_string(port) + ": " + reason_of(ec);
  if (ec == asio::error::address_in_use)
    message += ", by a hedgehogd of this machine perhaps; choose another port with --port";
  return Problem{kCannotCreate, message};
}

void Tunnel::run() {
  if (interrupted()) return;
  impl_->signals.async_wait([this](const error_code& ec, int) {
    if (!ec) impl_->io.stop();
  });
  spawn(impl_->io, impl_->accept());
  impl_->io.run();
}

}  // namespace hedgehog::client
