// SPDX-License-Identifier: MIT
// The game's web server: its page as files, and text messages with every open page on `/ws`. All of
// Boost.Beast is hidden behind this header, in one source file.
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>

namespace hedgehog::racer {

struct HubSettings {
  std::string address = "127.0.0.1";
  /// 0: any free port.
  std::uint16_t port = 7585;
  /// The folder with the page's files.
  std::string pages;
};

/// Used by one thread. Sockets are served only inside `serve_until`, without blocking on a page: a
/// page that reads slowly loses frames, one that floods cannot block the others.
class Hub {
 public:
  /// Id of an open page. Never reused.
  using PageId = std::uint64_t;

  struct Callbacks {
    /// A text message from a page. The returned text, unless empty, is sent back.
    std::function<std::string(PageId, std::string_view)> received;
    std::function<void(PageId)> left;
  };

  /// Limits of pages, beyond which an error is sent, and of connections, beyond which they are
  /// closed.
  static constexpr int kMaxPages = 16;
  static constexpr int kMaxConnections = 64;
  /// Limit of queued messages per page, besides the latest frame of each kind.
  static constexpr std::size_t kMaxWaiting = 64;
  static constexpr std::size_t kMaxReceivedBytes = 4096;

  /// Listens. std::runtime_error with a sentence if that fails.
  Hub(const HubSettings& settings, Callbacks callbacks);
  /// Closes all connections.
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// Serves sockets until `deadline`, or for a millisecond if it is in the past.
  void serve_until(std::chrono::steady_clock::time_point deadline);

  /// Sets the first message to every new page.
  void set_first_message(std::string text);
  /// Sends to every page, in order; if too many are queued for a page its oldest is dropped.
  void send(std::string_view text);
  /// Sends to every page: replaces a queued message of the same `kind` (below kKinds).
  void send_latest(std::size_t kind, std::string_view text);
  static constexpr std::size_t kKinds = 2;

  /// Sends the last message and all queued ones, for half a second at most.
  void announce_shutdown(std::string_view text);

  int pages() const noexcept;
  std::uint16_t port() const noexcept;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace hedgehog::racer
