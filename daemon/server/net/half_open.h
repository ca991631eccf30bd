// SPDX-License-Identifier: MIT
// Connections that need a token and have sent none yet: remote ones until the end of the TLS
// handshake and the log-in, local users without a role. Their number is bounded; a new one replaces
// the oldest, so that clients that are slow, or send garbage or nothing, do not exclude others.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/steady_timer.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>
#include <memory>
#include <string>
#include <utility>

namespace hedgehog::server {

/// io thread only. Made as a shared_ptr, which its tickets share, because some tickets are
/// destroyed only with the io_context.
class HalfOpen : public std::enable_shared_from_this<HalfOpen> {
 public:
  /// Maximum in total, and per address; beyond it, the oldest (of that address) is disconnected.
  static constexpr std::size_t kMax = 32;
  static constexpr std::size_t kMaxOfAddress = 8;
  static constexpr std::chrono::seconds kTimeout{10};  // until it is disconnected

  explicit HalfOpen(boost::asio::any_io_executor executor,
                    std::chrono::milliseconds timeout = kTimeout)
      : executor_(std::move(executor)), timeout_(timeout) {}
  HalfOpen(const HalfOpen&) = delete;
  HalfOpen& operator=(const HalfOpen&) = delete;

 private:
  struct Entry {
    std::uint64_t id;
    int descriptor;
    std::string host;
    bool ended;
    boost::asio::steady_timer timer;
  };

 public:
  /// A connection's entry, until it is released. Must be released before its socket is closed.
  class Ticket {
   public:
    Ticket() = default;
    Ticket(Ticket&& other) noexcept;
    Ticket& operator=(Ticket&& other) noexcept;
    ~Ticket() { release(); }
    void release() noexcept;
    explicit operator bool() const noexcept { return owner_ != nullptr; }

   private:
    friend class HalfOpen;
    Ticket(std::shared_ptr<HalfOpen> owner, std::list<Entry>::iterator entry)
        : owner_(std::move(owner)), entry_(entry) {}
    std::shared_ptr<HalfOpen> owner_;
    std::list<Entry>::iterator entry_{};
  };

  /// Adds the socket `descriptor` of `address` ("192.0.2.7:5000", "user 1000"). Disconnecting is a
  /// shutdown(2) in both directions, which ends pending operations on the socket.
  Ticket enter(int descriptor, const std::string& address);
  std::size_t size() const noexcept { return entries_.size(); }
  /// Number of connections disconnected for a timeout or too many connections.
  std::size_t disconnected() const noexcept { return disconnected_; }

 private:
  void make_space(const std::string& host);
  void expire(std::uint64_t id) noexcept;
  void disconnect(Entry& entry) noexcept;

  boost::asio::any_io_executor executor_;
  std::chrono::milliseconds timeout_;
  std::list<Entry> entries_;  // oldest first
  std::uint64_t last_id_ = 0;
  std::size_t disconnected_ = 0;
};

}  // namespace hedgehog::server
