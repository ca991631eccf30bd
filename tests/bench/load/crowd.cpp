// SPDX-License-Identifier: MIT
#include "tests/bench/load/crowd.h"

#include <sys/epoll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>

namespace hedgehog::bench {
namespace {

using Clock = std::chrono::steady_clock;

constexpr int kResponseTimeoutMs = 60'000;

}  // namespace

std::vector<double> round_trips(const std::function<void()>& one, double seconds) {
  std::vector<double> took_s;
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  for (auto now = Clock::now(); now < until || took_s.empty();) {
    one();
    const auto then = Clock::now();
    took_s.push_back(std::chrono::duration<double>(then - now).count());
    now = then;
  }
  return took_s;
}

Crowd::Crowd(int port, std::size_t clients, std::size_t in_flight, std::string_view request)
    : request_bytes_(request.size()), poll_(::epoll_create1(EPOLL_CLOEXEC)) {
  clients_.reserve(clients);
  for (std::size_t i = 0; i < in_flight; ++i) requests_ += request;
  for (std::size_t i = 0; i < clients; ++i) {
    Client& client = clients_.emplace_back(port);
    client.call(request);
    epoll_event event{};
    event.events = EPOLLIN;
    event.data.u64 = i;
    ::epoll_ctl(poll_, EPOLL_CTL_ADD, client.descriptor(), &event);
  }
}

Crowd::~Crowd() { ::close(poll_); }

std::size_t Crowd::run(double seconds) {
  std::size_t responses = 0;
  std::size_t pending = 0;
  const auto until = Clock::now() + std::chrono::duration<double>(seconds);
  for (Client& client : clients_) {
    client.send(requests_);
    pending += requests_.size() / request_bytes_;
  }
  std::array<epoll_event, 64> ready{};
  std::array<char, 64 * 1024> bytes;
  for (bool sending = true; pending > 0;) {
    sending = sending && Clock::now() < until;
    const int count = ::epoll_wait(poll_, ready.data(), ready.size(), kResponseTimeoutMs);
    if (count <= 0) throw std::runtime_error("a server does not answer");
    for (int i = 0; i < count; ++i) {
      Client& client = clients_[ready[static_cast<std::size_t>(i)].data.u64];
      const ssize_t got = ::recv(client.descriptor(), bytes.data(), bytes.size(), 0);
      if (got <= 0) throw std::runtime_error("a server closed its connection");
      const auto lines =
          static_cast<std::size_t>(std::count(bytes.begin(), bytes.begin() + got, '\n'));
      pending -= lines;
      responses += lines;
      if (!sending) continue;
      client.send(std::string_view(requests_).substr(0, lines * request_bytes_));
      pending += lines;
    }
  }
  return responses;
}

}  // namespace hedgehog::bench
