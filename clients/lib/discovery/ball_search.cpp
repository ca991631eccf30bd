// SPDX-License-Identifier: MIT
#include "clients/lib/discovery/ball_search.h"

#include <ifaddrs.h>
#include <net/if.h>
#include <netinet/in.h>

#include <algorithm>
#include <array>
#include <boost/asio.hpp>
#include <cerrno>
#include <charconv>
#include <functional>
#include <random>
#include <string>
#include <utility>

#include "clients/lib/discovery/choice.h"
#include "clients/lib/discovery/mdns_answers.h"

namespace hedgehog::client {

namespace asio = boost::asio;
using asio::ip::udp;
using boost::system::error_code;
using SteadyClock = std::chrono::steady_clock;

namespace {

constexpr std::uint16_t kMdnsPort = 5353;
constexpr int kMdnsHops = 255;  // RFC 6762, section 11
/// A lost query is replaced by the next, which also requests the missing records.
constexpr int kQueries = 3;
/// Limit of datagrams read in one call that does not block.
constexpr int kMaxDatagrams = 16;

std::uint16_t test_port() {
  const std::string text = process_environment("HEDGEHOG_MDNS_PORT").value_or("");
  std::uint16_t port = 0;
  std::from_chars(text.data(), text.data() + text.size(), port);
  return port;
}

std::vector<asio::ip::address_v4> ipv4_interfaces(error_code& error) {
  std::vector<asio::ip::address_v4> all;
  ifaddrs* first = nullptr;
  if (::getifaddrs(&first) != 0) {
    error.assign(errno, boost::system::system_category());
    return all;
  }
  for (const ifaddrs* one = first; one != nullptr; one = one->ifa_next) {
    if (one->ifa_addr == nullptr || one->ifa_addr->sa_family != AF_INET ||
        (one->ifa_flags & IFF_UP) == 0u)
      continue;
    const auto* address = reinterpret_cast<const sockaddr_in*>(one->ifa_addr);
    all.emplace_back(ntohl(address->sin_addr.s_addr));
  }
  ::freeifaddrs(first);
  return all;
}

std::uint16_t random_id() {
  std::random_device random;
  return static_cast<std::uint16_t>(random());
}

/// The queries and their answers, on an io_context of its own.
class MdnsExchange {
 public:
  using Enough = std::function<bool(const std::vector<DiscoveredBall>&)>;

  /// Ends after `time`, or when `enough` is true of the balls found (empty: never).
  MdnsExchange(std::chrono::milliseconds time, Enough enough)
      : time_(time), enough_(std::move(enough)) {
    error_code& error = failure_;
    socket_.open(udp::v4(), error);
    if (!error) socket_.bind({udp::v4(), 0}, error);
    if (!error) socket_.non_blocking(true, error);
    if (!error) socket_.set_option(asio::ip::multicast::hops(kMdnsHops), error);
    if (error) {
      done_ = true;
      return;
    }
    receive();
    send_query();
  }
  MdnsExchange(const MdnsExchange&) = delete;
  MdnsExchange& operator=(const MdnsExchange&) = delete;

  /// Whether it has ended, by `deadline` at the latest.
  bool run(SteadyClock::time_point deadline) {
    io_.restart();
    for (int i = 0; i < kMaxDatagrams && !done_ && io_.poll_one() > 0; ++i) {
    }
    while (!done_ && SteadyClock::now() < deadline) {
      io_.restart();
      io_.run_one_until(deadline);
    }
    return done_;
  }

  /// Why the network could not be searched; no error: it was searched.
  const error_code& failure() const noexcept { return failure_; }
  std::vector<DiscoveredBall> balls() const { return answers_.balls(); }

 private:
  void send_query() {
    const std::string query = answers_.query();
    const asio::ip::address_v4 group({224, 0, 0, 251});
    const std::uint16_t port = test_port();
    const udp::endpoint to(group, port != 0 ? port : kMdnsPort);
    const auto interfaces =
        port != 0 ? std::vector{asio::ip::address_v4::loopback()} : ipv4_interfaces(failure_);
    if (failure_) {
      done_ = true;
      return;
    }
    for (const auto& interface : interfaces) {
      // An interface that has been removed meanwhile is skipped.
      error_code error;
      socket_.set_option(asio::ip::multicast::outbound_interface(interface), error);
      if (!error) socket_.send_to(asio::buffer(query), to, 0, error);
    }
    ++queries_sent_;
    timer_.expires_at(begin_ + time_ * queries_sent_ / kQueries);
    timer_.async_wait([this](const error_code& error) {
      if (error || done_) return;
      if (queries_sent_ == kQueries)
        done_ = true;
      else
        send_query();
    });
  }

  void receive() {
    socket_.async_receive(
        asio::buffer(packet_),
        [this](const error_code& error, std::size_t size) {
          if (error || done_) return;
          done_ = answers_.read({packet_.data(), size}) && enough_ && enough_(answers_.balls());
          if (!done_) receive();
        });
  }

  std::chrono::milliseconds time_;
  Enough enough_;
  SteadyClock::time_point begin_ = SteadyClock::now();
  asio::io_context io_{1};
  udp::socket socket_{io_};
  asio::steady_timer timer_{io_};
  mdns::Answers answers_{random_id()};
  std::array<char, 16 * 1024> packet_{};
  int queries_sent_ = 0;
  bool done_ = false;
  error_code failure_;
};

ClientError no_network(const error_code& failure) {
  return {Failure::kNoDaemon, "the network cannot be searched: " + failure.message(), {}};
}

/// Whether each ball requested by name was found; without a name a second ball may still answer.
bool found_all_named(const std::vector<Address>& addresses,
                     const std::vector<DiscoveredBall>& balls) {
  return std::all_of(
      addresses.begin(), addresses.end(),
      [&](const Address& address) {
        return !address.mdns ||
               (!address.host.empty() && !named_balls(address.host, balls).empty());
      });
}

}  // namespace

Outcome<std::vector<DiscoveredBall>> discover(std::chrono::milliseconds time) {
  MdnsExchange exchange(time, {});
  while (!exchange.run(SteadyClock::now() + time)) {
  }
  if (exchange.failure()) return no_network(exchange.failure());
  return exchange.balls();
}

bool needs_search(const std::vector<Address>& addresses) {
  return std::any_of(
      addresses.begin(), addresses.end(), [](const Address& address) { return address.mdns; });
}

struct BallSearch::Impl {
  explicit Impl(std::vector<Address> given)
      : addresses(std::move(given)), exchange(kSearchTime, [this](const auto& balls) {
          return found_all_named(addresses, balls);
        }) {}

  Located located() const {
    if (exchange.failure()) return no_network(exchange.failure());
    std::vector<Address> all;
    for (const Address& address : addresses) {
      if (!address.mdns) {
        all.push_back(address);
        continue;
      }
      if (auto missing = missing_fingerprint(address)) return *std::move(missing);
      const auto balls = chosen_ball(address.host, exchange.balls());
      if (!balls) return balls.error();
      for (const DiscoveredBall& ball : *balls) {
        all.push_back(address);
        all.back().mdns = false;
        all.back().tls = true;
        all.back().host = ball.address.host;
        all.back().port = ball.address.port;
      }
    }
    return all;
  }

  std::vector<Address> addresses;
  MdnsExchange exchange;
};

BallSearch::BallSearch(std::vector<Address> addresses)
    : impl_(std::make_unique<Impl>(std::move(addresses))) {}
BallSearch::~BallSearch() = default;
BallSearch::BallSearch(BallSearch&&) noexcept = default;
BallSearch& BallSearch::operator=(BallSearch&&) noexcept = default;

std::optional<BallSearch::Located> BallSearch::located(SteadyClock::time_point deadline) {
  if (!impl_->exchange.run(deadline)) return std::nullopt;
  return impl_->located();
}

BallSearch::Located locate(const std::vector<Address>& addresses) {
  if (!needs_search(addresses)) return addresses;
  BallSearch search(addresses);
  for (;;)
    if (auto located = search.located(SteadyClock::now() + kSearchTime)) return *std::move(located);
}

}  // namespace hedgehog::client
