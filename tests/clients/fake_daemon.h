// SPDX-License-Identifier: MIT
// A daemon scripted by a test: one conversation, on its own thread.
#pragma once

#include <boost/asio.hpp>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <istream>
#include <memory>
#include <string>
#include <string_view>
#include <thread>
#include <utility>

#include "clients/lib/address.h"

namespace hedgehog::client {

/// Upper bound for a required event on a busy machine.
inline constexpr std::chrono::milliseconds kLongTimeout{20'000};

/// The client library's response timeout in the test programs that use this daemon: set before
/// `main`, as the library reads it once.
inline const bool kResponseTimeoutSet = ::setenv("HEDGEHOG_PATIENCE_MS", "60000", 1) == 0;

/// The daemon's end of the conversation.
class FakePeer {
 public:
  using Socket = boost::asio::generic::stream_protocol::socket;
  explicit FakePeer(Socket socket) : socket_(std::move(socket)) {}

  /// The next line from the client; empty at the end of the stream.
  std::string read() {
    boost::system::error_code error;
    boost::asio::read_until(socket_, buffer_, '\n', error);
    std::istream stream(&buffer_);
    std::string line;
    std::getline(stream, line);
    return line;
  }
  void send(std::string_view bytes) {
    boost::system::error_code ignored;
    boost::asio::write(socket_, boost::asio::buffer(bytes), ignored);
  }
  void send_line(std::string_view line) { send(std::string(line) + "\n"); }

 private:
  Socket socket_;
  boost::asio::streambuf buffer_;
};

/// A reserved port without a listener; no other program can listen on it during this object's
/// lifetime.
class SilentPort {
 public:
  Address address() const { return {.host = "127.0.0.1", .port = socket_.local_endpoint().port()}; }

 private:
  boost::asio::io_context io_{1};
  boost::asio::ip::tcp::socket socket_{io_,
                                       {boost::asio::ip::address_v4::loopback(), std::uint16_t{0}}};
};

/// Listens at once; runs `script` when a client has connected, and then closes the
/// connection.
class FakeDaemon {
 public:
  using Script = std::function<void(FakePeer&)>;

  explicit FakeDaemon(Script script)
      : FakeDaemon(boost::asio::ip::tcp::endpoint(boost::asio::ip::address_v4::loopback(), 0),
                   std::move(script)) {}
  FakeDaemon(const std::string& path, Script script)
      : FakeDaemon(boost::asio::local::stream_protocol::endpoint(path), std::move(script)) {}
  ~FakeDaemon() { finish(); }
  FakeDaemon(const FakeDaemon&) = delete;
  FakeDaemon& operator=(const FakeDaemon&) = delete;

  /// Waits for the end of the conversation; afterwards the test may read what it recorded.
  void finish() {
    if (thread_.joinable()) thread_.join();
  }

  /// REQUIRES: it listens on TCP.
  Address address() const { return {.host = "127.0.0.1", .port = port_}; }

 private:
  template <class Endpoint>
  FakeDaemon(const Endpoint& endpoint, Script script) {
    using Protocol = typename Endpoint::protocol_type;
    auto acceptor = std::make_shared<typename Protocol::acceptor>(io_, endpoint);
    if constexpr (requires { acceptor->local_endpoint().port(); })
      port_ = acceptor->local_endpoint().port();
    thread_ = std::thread([acceptor, script = std::move(script)] {
      FakePeer peer{FakePeer::Socket(acceptor->accept())};
      script(peer);
    });
  }

  boost::asio::io_context io_{1};
  std::uint16_t port_ = 0;
  std::thread thread_;
};

}  // namespace hedgehog::client
