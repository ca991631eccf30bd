// SPDX-License-Identifier: MIT
// The game's side of its page: tells every open page what is to be seen, and knows what the pages
// asked. Serves HTTP and WebSocket in the game's own thread, in the pauses between frames.
//
//   Server server({.port = 7585, .pages = default_pages_folder()}, race.track());
//   for (auto next = steady_clock::now();; next += 16ms) {
//     const Asked asked = server.take();
//     server.tell(race.step(asked.keys), {});
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

/// What the pages asked since it was taken the last time.
struct Asked {
  /// Of the page that pressed last; neutral when it has gone or been silent for kKeysLease.
  Controls keys{};
  bool reset = false;
  std::optional<bool> pause{};
  std::optional<Mode> mode{};
};

/// One thread. Nothing here waits for a page.
class Server {
 public:
  /// A page says again what it holds, ten times a second: a hand that cannot be heard has let go.
  static constexpr std::chrono::milliseconds kKeysLease{600};

  /// Listens. std::runtime_error: it cannot, as a sentence.
  Server(const HubSettings& settings, const Track& track);

  /// To be called with the time of the next frame; returns then.
  void serve_until(std::chrono::steady_clock::time_point deadline) { hub_.serve_until(deadline); }

  /// The newest counts: a page that is too slow misses the others.
  void publish(const Scene& scene, const Stand& stand);
  void publish(const BallView& ball);
  /// One after the other.
  void publish(const Felt& felt);
  void publish(const FinishedLap& lap);
  void announce_shutdown(std::string_view reason) { hub_.announce_shutdown(shutdown_text(reason)); }

  Asked take(std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now());
  int pages() const noexcept { return hub_.pages(); }
  std::uint16_t port() const noexcept { return hub_.port(); }

 private:
  std::string received(Hub::PageId page, std::string_view text);
  void left(Hub::PageId page);

  Asked asked_{};
  Hub::PageId steers_ = 0;
  std::map<Hub::PageId, Controls> held_;
  std::chrono::steady_clock::time_point keys_end_{};
  Hub hub_;
};

}  // namespace hedgehog::racer
