// SPDX-License-Identifier: MIT
// One open page: its WebSocket and a bounded queue of messages. For hub.cpp only, because of Beast.
#pragma once

#include <array>
#include <boost/asio/steady_timer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/websocket.hpp>
#include <deque>
#include <string>
#include <string_view>
#include <utility>

#include "clients/racer/server/hub.h"

namespace hedgehog::racer {

/// Owned by its two coroutines.
struct OpenPage {
  using Stream = boost::beast::websocket::stream<boost::beast::tcp_stream>;

  OpenPage(Hub::PageId number, Stream socket)
      : id(number), stream(std::move(socket)), wake(stream.get_executor()) {
    wake.expires_at(boost::asio::steady_timer::time_point::max());
  }

  /// The next message; empty: none is queued.
  std::string next() {
    std::string text;
    if (!waiting.empty()) {
      text = std::move(waiting.front());
      waiting.pop_front();
      return text;
    }
    // Round robin, so that a slow page receives messages of each kind.
    for (std::size_t i = 0; i < latest.size() && text.empty(); ++i) {
      turn = (turn + 1) % latest.size();
      std::swap(text, latest[turn]);
    }
    return text;
  }
  bool idle() const {
    return !writing && waiting.empty() && latest[0].empty() && latest[1].empty();
  }
  void queue(std::string_view text) {
    if (waiting.size() == Hub::kMaxWaiting) waiting.pop_front();
    waiting.emplace_back(text);
    wake.cancel();
  }
  void replace(std::size_t kind, std::string_view text) {
    latest[kind] = text;
    wake.cancel();
  }
  void close() {
    boost::system::error_code ignored;
    open = false;
    boost::beast::get_lowest_layer(stream).socket().close(ignored);
    wake.cancel();
  }

  Hub::PageId id;
  Stream stream;
  boost::asio::steady_timer wake;
  std::deque<std::string> waiting{};
  std::array<std::string, Hub::kKinds> latest{};
  std::size_t turn = Hub::kKinds - 1;
  bool writing = false;
  bool open = true;
};

}  // namespace hedgehog::racer
