// SPDX-License-Identifier: MIT
// Arbitrary input from a browser: "host\norigin\nmessage" to the origin checks of the daemon's and
// of the game's pages, and to the game.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>
#include <variant>

#include "clients/racer/server/host_check.h"
#include "clients/racer/server/messages.h"
#include "daemon/server/net/http/origin_check.h"

namespace {

namespace racer = hedgehog::racer;
namespace server = hedgehog::server;

void require(bool law) {
  if (!law) std::abort();
}

bool same_but_for_case(std::string_view a, std::string_view b) {
  return std::equal(
      a.begin(), a.end(), b.begin(), b.end(),
      [](char x, char y) {
        const auto lower = [](char c) {
          return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c;
        };
        return lower(x) == lower(y);
      });
}

/// A page may connect only to the server from which it was loaded.
bool is_at(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  return origin.size() > kScheme.size() &&
         same_but_for_case(origin.substr(0, kScheme.size()), kScheme) &&
         same_but_for_case(origin.substr(kScheme.size()), host);
}

bool is_between(double value, double min, double max) { return value >= min && value <= max; }

void check_origin(std::string_view host, std::string_view origin) {
  server::HttpRequest request{"GET", "/ws", std::string(host), std::string(origin)};
  const auto refused = server::refused(request, {});
  require(refused || (server::is_own_host(host) && is_at(origin, host)));
  if (refused) {
    const std::string& words = *refused->answer.body;
    require(
        std::all_of(words.begin(), words.end() - 1, [](char c) { return c >= 0x20 && c < 0x7f; }));
  }
  require(!racer::may_connect(host, origin) || is_at(origin, host));
}

void check_message(std::string_view text) {
  const racer::PageMessage message = racer::page_message(text);
  if (const auto* keys = std::get_if<racer::KeysHeld>(&message)) {
    require(is_between(keys->controls.steer, -1, 1) && is_between(keys->controls.throttle, 0, 1) &&
            is_between(keys->controls.brake, 0, 1));
  } else if (const auto* not_understood = std::get_if<racer::InvalidMessage>(&message)) {
    require(!not_understood->why.empty() && !racer::refusal_text(not_understood->why).empty());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::string_view rest(reinterpret_cast<const char*>(data), size);
  const auto line = [&rest] {
    const std::string_view first = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(first.size() + 1, rest.size()));
    return first;
  };
  const std::string_view host = line();
  const std::string_view origin = line();
  check_origin(host, origin);
  check_message(rest);
  return 0;
}
