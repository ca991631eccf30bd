// SPDX-License-Identifier: MIT
#include "tests/bench/load/subscribers.h"

#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <charconv>
#include <chrono>
#include <cmath>
#include <stdexcept>

namespace hedgehog::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::int64_t kPeriodNs = 1'000'000'000 / kSubscribedHz;
constexpr std::size_t kReadBytes = 64 * 1024;
constexpr int kWaitMs = 20;

constexpr std::string_view kSubscribe =
    R"({"jsonrpc":"2.0","id":1,"method":"telemetry.subscribe",)"
    R"("params":{"rate_hz":100,"fields":["state","temperature_c","current_a"]}})"
    "\n";

/// 0 if the line is no telemetry.
std::int64_t time_ns_of(std::string_view line) {
  constexpr std::string_view kKey = R"("time_ns":)";
  const std::size_t at = line.find(kKey);
  std::int64_t value = 0;
  if (at != line.npos)
    std::from_chars(line.data() + at + kKey.size(), line.data() + line.size(), value);
  return value;
}

}  // namespace

Subscribers::Subscribers(int port, std::size_t count)
    : bytes_(kReadBytes, '\0'), poll_(::epoll_create1(EPOLL_CLOEXEC)) {
  all_.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    Client& client = all_.emplace_back(Subscriber{Client(port), {}, 0}).client;
    client.send(kSubscribe);
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = i;
    ::epoll_ctl(poll_, EPOLL_CTL_ADD, client.descriptor(), &event);
  }
}

Subscribers::~Subscribers() { ::close(poll_); }

Received Subscribers::run(double seconds) {
  Received received;
  const auto begun = Clock::now();
  const auto until = begun + std::chrono::duration<double>(seconds);
  std::array<epoll_event, 256> ready{};
  while (Clock::now() < until) {
    const int count = ::epoll_wait(poll_, ready.data(), ready.size(), kWaitMs);
    for (int i = 0; i < count; ++i)
      read(all_[ready[static_cast<std::size_t>(i)].data.u64], received);
  }
  received.seconds = std::chrono::duration<double>(Clock::now() - begun).count();
  return received;
}

void Subscribers::read(Subscriber& from, Received& received) {
  const ssize_t got = ::recv(from.client.descriptor(), bytes_.data(), bytes_.size(), MSG_DONTWAIT);
  if (got == 0) throw std::runtime_error("a server closed the connection of a subscriber");
  if (got < 0) return;
  from.rest.append(bytes_.data(), static_cast<std::size_t>(got));
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = from.rest.find('\n', begin)) != std::string::npos;
       begin = end + 1) {
    const std::int64_t now_ns = time_ns_of(std::string_view(from.rest).substr(begin, end - begin));
    if (now_ns == 0) continue;
    ++received.notifications;
    const auto periods = std::llround(static_cast<double>(now_ns - from.last_ns) / kPeriodNs);
    if (from.last_ns != 0 && periods > 1) received.missing += static_cast<std::size_t>(periods - 1);
    from.last_ns = now_ns;
  }
  from.rest.erase(0, begin);
}

}  // namespace hedgehog::bench
