// SPDX-License-Identifier: MIT
// A ball that announces itself by multicast DNS, on the loopback interface only.
#pragma once

#include <array>
#include <atomic>
#include <boost/asio/buffer.hpp>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/multicast.hpp>
#include <boost/asio/ip/udp.hpp>
#include <cstdint>
#include <string>
#include <thread>
#include <utility>

namespace hedgehog {

/// The response that announces "ball-7", serial number 0007, of lab.local, at this IPv4 address.
inline std::string mdns_announcement(const std::string& address, std::uint16_t port) {
  using namespace std::string_literals;
  const auto number = [](std::size_t value) {
    return std::string{static_cast<char>(value >> 8u), static_cast<char>(value & 0xffu)};
  };
  const auto record = [&](const std::string& name, char kind, const std::string& data) {
    return name + '\0' + kind + "\0\1\0\0\0\x0a"s + number(data.size()) + data;
  };
  const std::string service = "\x09_hedgehog\x04_tcp\x05local\0"s;
  const std::string instance = "\6ball-7" + service;
  const std::string host = "\3lab\5local\0"s;
  const auto bytes = boost::asio::ip::make_address_v4(address).to_bytes();
  return "\0\0\x84\0\0\0\0\4\0\0\0\0"s + record(service, 12, instance) +
         record(instance, 33, "\0\0\0\0"s + number(port) + host) +
         record(instance, 16, "\x0cprotocol=1.0\x0bserial=0007\5tls=1") +
         record(host, 1, std::string(bytes.begin(), bytes.end()));
}

/// Responds to each query at its own port with one response, on its own thread.
class MdnsResponder {
 public:
  /// `response`: its id is replaced by the query's; empty: none is sent. A held responder sends its
  /// responses after `release()`.
  explicit MdnsResponder(std::string response, bool held = false)
      : response_(std::move(response)), is_released_(!held) {
    namespace ip = boost::asio::ip;
    socket_.set_option(
        ip::multicast::join_group(ip::make_address_v4("224.0.0.251"), ip::address_v4::loopback()));
    thread_ = std::thread([this] { serve(); });
  }
  MdnsResponder(const MdnsResponder&) = delete;
  MdnsResponder& operator=(const MdnsResponder&) = delete;
  ~MdnsResponder() {
    release();
    Udp::socket own(io_, Udp::v4());
    own.send_to(boost::asio::const_buffer(), {boost::asio::ip::address_v4::loopback(), port()});
    thread_.join();
  }

  /// From any thread.
  void release() {
    is_released_ = true;
    is_released_.notify_all();
  }
  std::uint16_t port() const { return socket_.local_endpoint().port(); }

 private:
  using Udp = boost::asio::ip::udp;

  /// Returns at an empty datagram.
  void serve() {
    std::array<char, 1500> query{};
    for (;;) {
      Udp::endpoint sender;
      if (socket_.receive_from(boost::asio::buffer(query), sender) == 0) return;
      if (response_.empty()) continue;
      is_released_.wait(false);
      response_.replace(0, 2, query.data(), 2);
      socket_.send_to(boost::asio::buffer(response_), sender);
    }
  }

  std::string response_;
  std::atomic<bool> is_released_;
  boost::asio::io_context io_;
  Udp::socket socket_{io_, {Udp::v4(), 0}};
  std::thread thread_;
};

}  // namespace hedgehog
