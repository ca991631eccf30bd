// SPDX-License-Identifier: MIT
// Reference server: a telemetry notification of three fields RATE times per second (1 to 10000),
// serialised once and sent from one buffer to each client that has sent something. Sends no
// responses. Prints its port.
#include <array>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/detached.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/redirect_error.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <boost/asio/write.hpp>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <iostream>
#include <list>
#include <memory>
#include <string>

namespace {

namespace asio = boost::asio;
using asio::ip::tcp;
using boost::system::error_code;
using Line = std::shared_ptr<const std::string>;

constexpr int kMaxRate = 10'000;

struct Subscriber {
  explicit Subscriber(tcp::socket connected) : socket(std::move(connected)) {}
  tcp::socket socket;
  std::deque<Line> waiting;
  bool subscribed = false;
  bool closed = false;
};
using SubscriberPtr = std::shared_ptr<Subscriber>;

Line notification(std::int64_t time_ns) {
  std::array<char, 512> text{};
  const double warm = 25.0 + static_cast<double>(time_ns % 1000) * 1e-3;
  const int length = std::snprintf(
      text.data(), text.size(),
      R"({"jsonrpc":"2.0","method":"telemetry","params":{"time_ns":%lld,"state":"armed",)"
      R"("temperature_c":{"sensor":%.6f,"model":%.6f,"coils":[%.6f,%.6f,%.6f],"upper":%.6f,)"
      R"("core":%.6f,"skin":null,"age_ms":1},"current_a":[0.0,%.6f,0.0]}})"
      "\n",
      static_cast<long long>(time_ns), warm, warm, warm, warm, warm, warm, warm, warm);
  return std::make_shared<const std::string>(text.data(), static_cast<std::size_t>(length));
}

void send_next(const SubscriberPtr& to) {
  asio::async_write(
      to->socket, asio::buffer(*to->waiting.front()),
      [to](const error_code& ec, std::size_t) {
        to->waiting.pop_front();
        to->closed = to->closed || ec;
        if (!to->closed && !to->waiting.empty()) send_next(to);
      });
}

void send(const SubscriberPtr& to, const Line& line) {
  if (to->closed || !to->subscribed) return;
  to->waiting.push_back(line);
  if (to->waiting.size() == 1) send_next(to);
}

asio::awaitable<void> read(SubscriberPtr from) {
  std::array<char, 512> buffer;
  error_code ec;
  while (!ec) {
    co_await from->socket.async_read_some(asio::buffer(buffer),
                                          asio::redirect_error(asio::use_awaitable, ec));
    from->subscribed = true;
  }
  from->closed = true;
}

asio::awaitable<void> accept(tcp::acceptor acceptor, std::list<SubscriberPtr>& all) {
  for (;;) {
    tcp::socket socket = co_await acceptor.async_accept(asio::use_awaitable);
    socket.set_option(tcp::no_delay(true));
    all.push_back(std::make_shared<Subscriber>(std::move(socket)));
    asio::co_spawn(acceptor.get_executor(), read(all.back()), asio::detached);
  }
}

asio::awaitable<void> publish(asio::io_context& io, int rate, std::list<SubscriberPtr>& all) {
  asio::steady_timer timer(io);
  const std::chrono::nanoseconds period(1'000'000'000 / rate);
  for (auto due = std::chrono::steady_clock::now() + period;; due += period) {
    timer.expires_at(due);
    co_await timer.async_wait(asio::use_awaitable);
    const Line line = notification(due.time_since_epoch().count());
    all.remove_if([](const SubscriberPtr& one) { return one->closed; });
    for (const SubscriberPtr& one : all) send(one, line);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int rate = argc == 2 ? std::atoi(argv[1]) : 0;
  if (rate < 1 || rate > kMaxRate) {
    std::cerr << "reference_telemetry_sender RATE\n";
    return EXIT_FAILURE;
  }
  asio::io_context io(1);
  std::list<SubscriberPtr> all;
  tcp::acceptor acceptor(io, {asio::ip::address_v4::loopback(), 0});
  acceptor.listen(1024);
  std::cout << "listening on 127.0.0.1:" << acceptor.local_endpoint().port() << std::endl;
  asio::co_spawn(io, accept(std::move(acceptor), all), asio::detached);
  asio::co_spawn(io, publish(io, rate, all), asio::detached);
  io.run();
}
