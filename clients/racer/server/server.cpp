// SPDX-License-Identifier: MIT
#include "clients/racer/server/server.h"

#include <utility>
#include <variant>

namespace hedgehog::racer {
namespace {

constexpr std::size_t kSceneKind = 0;
constexpr std::size_t kBallKind = 1;

}  // namespace

Server::Server(const HubSettings& settings, const Track& track)
    : hub_(settings,
           {[this](Hub::PageId page, std::string_view text) { return received(page, text); },
            [this](Hub::PageId page) { left(page); }}) {
  hub_.set_first_message(track_text(track));
}

void Server::publish(const Scene& scene, const GameStatus& stand) {
  if (hub_.pages() > 0) hub_.send_latest(kSceneKind, scene_text(scene, stand));
}

void Server::publish(const BallView& ball) {
  if (hub_.pages() > 0) hub_.send_latest(kBallKind, ball_text(ball));
}

void Server::publish(const Felt& felt) {
  if (hub_.pages() > 0) hub_.send(felt_text(felt));
}

void Server::publish(const FinishedLap& lap) { hub_.send(lap_text(lap)); }

PageRequests Server::take(std::chrono::steady_clock::time_point now) {
  if (now > keys_end_) requests_.keys = {};
  const Controls keys = requests_.keys;
  return std::exchange(requests_, PageRequests{.keys = keys});
}

std::string Server::received(Hub::PageId page, std::string_view text) {
  const PageMessage message = page_message(text);
  if (const auto* held = std::get_if<KeysHeld>(&message)) {
    const Controls before = std::exchange(held_[page], held->controls);
    const bool pressed = held->controls != before && held->controls != Controls{};
    if (page != active_page_ && !pressed) return {};
    requests_.keys = held->controls;
    active_page_ = page;
    keys_end_ = std::chrono::steady_clock::now() + kKeysLease;
  } else if (std::holds_alternative<ResetRequest>(message)) {
    requests_.reset = true;
  } else if (const auto* pause = std::get_if<PauseRequest>(&message)) {
    requests_.pause = pause->on;
  } else if (const auto* wanted = std::get_if<ModeRequest>(&message)) {
    requests_.mode = wanted->mode;
  } else if (const auto* broken = std::get_if<InvalidMessage>(&message)) {
    return refusal_text(broken->why);
  }
  return {};
}

void Server::left(Hub::PageId page) {
  held_.erase(page);
  if (page == active_page_) {
    requests_.keys = {};
    active_page_ = 0;
  }
}

}  // namespace hedgehog::racer
