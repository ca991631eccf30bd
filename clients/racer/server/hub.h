// SPDX-License-Identifier: MIT
// The game's web server: its page as files, and text messages with every page that is open, on
// `/ws`. All of Boost.Beast is behind this header, in one source file.
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
  /// 0: a free one.
  std::uint16_t port = 7585;
  /// The folder with the page's files.
  std::string pages;
};

/// One thread, the one that calls it. Sockets are served only inside `serve_until`, never waited
/// for: a page that reads slowly loses frames, one that floods loses its turn.
class Hub {
 public:
  /// A page, as long as it is open. Never used again.
  using PageId = std::uint64_t;

  struct Callbacks {
    /// A page sent a text message. What it returns, unless empty, is sent back.
    std::function<std::string(PageId, std::string_view)> received;
    std::function<void(PageId)> left;
  };

  /// At most this many pages, more are told so, and this many connections, more are closed.
  static constexpr int kMaxPages = 16;
  static constexpr int kMaxConnections = 64;
  /// Messages that wait for one page, besides the latest frame of each kind.
  static constexpr std::size_t kMaxWaiting = 64;
  static constexpr std::size_t kMaxReceivedBytes = 4096;

  /// Listens. std::runtime_error: it cannot, as a sentence.
  Hub(const HubSettings& settings, Callbacks callbacks);
  /// What is open is closed.
  ~Hub();
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  /// Serves sockets until then, and for a millisecond when it is past.
  void serve_until(std::chrono::steady_clock::time_point deadline);

  /// The first message of every page that comes from now on.
  void greet_with(std::string text);
  /// To every page, each one in turn; a page for which too many wait loses the oldest.
  void send(std::string_view text);
  /// To every page: replaces what still waits of this `kind` (below kKinds).
  void send_latest(std::size_t kind, std::string_view text);
  static constexpr std::size_t kKinds = 2;

  /// The last message; what waits is sent, half a second at most.
  void announce_shutdown(std::string_view text);

  int pages() const noexcept;
  std::uint16_t port() const noexcept;

 private:
  struct Rooms;
  std::unique_ptr<Rooms> rooms_;
};

}  // namespace hedgehog::racer
