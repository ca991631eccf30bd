// SPDX-License-Identifier: MIT
// The game's server of its page: sends the state to every open page, and collects the requests of
// the pages. Serves HTTP and WebSocket in the game's own thread, in the pauses between frames.
//
//   Server server({.port = 7585, .pages = default_pages_folder()}, race.track());
//   for (auto next = steady_clock::now();; next += 16ms) {
//     const PageRequests asked = server.take();
//     server.publish(race.step(asked.keys), {});
//     server.serve_until(next);
//   }
#pragma once

#include <chrono>
#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "clients/racer/server/hub.h"
#include "clients/racer/server/messages.h"

namespace hedgehog::racer {

/// Requests of the pages since the last `take`.
struct PageRequests {
  /// Of the page with the latest key press; neutral if it was closed or silent for kKeysLease.
  Controls keys{};
  bool reset = false;
  std::optional<bool> pause{};
  std::optional<Mode> mode{};
};

/// One thread. No call blocks on a page.
class Server {
 public:
  /// A page repeats its pressed keys ten times a second; without messages they count as released.
  static constexpr std::chrono::milliseconds kKeysLease{600};

  /// Listens. std::runtime_error with a sentence if that fails.
  Server(const HubSettings& settings, const Track& track);

  /// Call it with the time of the next frame; returns then.
  void serve_until(std::chrono::steady_clock::time_point deadline) { hub_.serve_until(deadline); }

  /// Only the newest is sent: a slow page misses the others.
  void publish(const Scene& scene, const GameStatus& stand);
  void publish(const BallView& ball);
  /// Queued in order.
  void publish(const Felt& felt);
  void publish(const FinishedLap& lap);
  void announce_shutdown(std::string_view reason) { hub_.announce_shutdown(shutdown_text(reason)); }

  PageRequests take(std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  int pages() const noexcept { return hub_.pages(); }
  std::uint16_t port() const noexcept { return hub_.port(); }

 private:
  std::string received(Hub::PageId page, std::string_view text);
  void left(Hub::PageId page);

  PageRequests requests_{};
  Hub::PageId active_page_ = 0;
  std::map<Hub::PageId, Controls> held_;
  std::chrono::steady_clock::time_point keys_end_{};
  Hub hub_;
};

}  // namespace hedgehog::racer
