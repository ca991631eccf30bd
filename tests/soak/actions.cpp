// SPDX-License-Identifier: MIT
#include "tests/soak/actions.h"

#include <array>
#include <utility>
#include <vector>

#include "tests/e2e/raw_client.h"
#include "tests/soak/damage.h"
#include "tests/soak/json_text.h"

namespace hedgehog::soak {
namespace {

/// Makes the sequences of neighbouring seeds unrelated.
constexpr std::uint64_t kStride = 0x9e3779b97f4a7c15;

}  // namespace

Configuration random_configuration(Random& random) {
  Configuration made;
  if (random.percent(60)) made.current_a = 2.0 + 0.1 * static_cast<double>(random.below(131));
  std::string limit;
  protocol::append_number(limit, made.current_a);
  const bool small_queue = random.percent(50);
  const std::string timeout = std::to_string(random.between(1, 3));
  const std::string max = random.percent(20) ? "5" : "64";
  made.json = R"({"limits":{"current_a":)" + limit + R"(},"connections":{"queue_bytes":)" +
              (small_queue ? "262144" : "1048576") + R"(,"write_timeout_s":)" + timeout +
              R"(,"max":)" + max + R"(},"simulator":{"seed":)" +
              std::to_string(random.below(1000)) + "}}";
  return made;
}

Actions::Actions(Random& random, RequestGenerator& generator, Traffic& traffic, std::uint64_t seed)
    : random_(random), generator_(generator), traffic_(traffic), seed_(seed) {}

void Actions::act() {
  random_ = Random(seed_ + ++count_ * kStride);
  struct Choice {
    int weight;
    void (Actions::*action)();
  };
  static constexpr std::array kChoices{
      Choice{50, &Actions::requests},      Choice{9, &Actions::batches},
      Choice{9, &Actions::damaged_line},   Choice{2, &Actions::long_line},
      Choice{3, &Actions::partial_line},   Choice{4, &Actions::new_client},
      Choice{3, &Actions::disconnect},     Choice{2, &Actions::flood},
      Choice{4, &Actions::read_again},     Choice{3, &Actions::subscribe},
      Choice{2, &Actions::web_page},       Choice{2, &Actions::web_frames},
      Choice{1, &Actions::foreign_client}, Choice{1, &Actions::reload},
      Choice{5, &Actions::repair_ball}};
  std::size_t all = 0;
  for (const Choice& choice : kChoices) all += static_cast<std::size_t>(choice.weight);
  auto left = static_cast<int>(random_.below(all));
  const Choice* chosen = kChoices.begin();
  while ((left -= chosen->weight) >= 0) ++chosen;
  (this->*chosen->action)();
  while (traffic_.pump()) {
  }
}

Transport Actions::any_transport() { return static_cast<Transport>(random_.below(3)); }

Peer& Actions::random_peer() {
  const std::size_t place = random_.below(Traffic::kPlaces);
  const Transport transport = any_transport();
  Peer* const there = traffic_.peer(place);
  return there != nullptr ? *there : traffic_.connect(place, transport, 0);
}

void Actions::send(Peer& peer, const std::string& message) {
  const bool may_arm = message.find("device.a") != std::string::npos ||
                       message.find("boot_loader") != std::string::npos;
  const int fragments = random_.percent(10) ? static_cast<int>(random_.between(2, 9)) : 1;
  if (arms_ || !may_arm) traffic_.send(peer, message, fragments);
}

void Actions::requests() {
  Peer& peer = random_peer();
  const std::size_t count = random_.percent(5) ? 100 : 1 + random_.below(8);
  for (std::size_t i = 0; i < count; ++i)
    send(peer, random_.percent(80) ? generator_.valid() : generator_.invalid());
}

void Actions::batches() {
  Peer& peer = random_peer();
  send(peer, generator_.batch());
}

void Actions::damaged_line() {
  Peer& peer = random_peer();
  const std::string line = random_.percent(70) ? generator_.valid() : generator_.batch();
  send(peer, one_line(damaged(random_, line)));
}

void Actions::long_line() {
  Peer& peer = random_peer();
  const std::string ping = generator_.request("ping");
  if (random_.percent(50))
    send(peer, ping + std::string(e2e::kMaxLine - ping.size(), ' '));
  else
    peer.send_too_long(e2e::kMaxLine + random_.below(100'000));
}

void Actions::partial_line() {
  Peer& peer = random_peer();
  const std::string line = generator_.valid();
  const std::size_t first = 1 + random_.below(line.size() - 1);
  if (peer.transport() == Transport::kWebSocket || (!arms_ && line.find("device.a") != line.npos))
    return;
  peer.send_in_parts(line, first);
}

void Actions::new_client() {
  const std::size_t place = random_.below(Traffic::kPlaces);
  const Transport transport = any_transport();
  const int buffer = random_.percent(30) ? 4096 : 0;
  if (Peer* const there = traffic_.peer(place)) there->close();
  traffic_.connect(place, transport, buffer);
}

void Actions::disconnect() {
  Peer& peer = random_peer();
  switch (random_.below(3)) {
    case 0:
      peer.close();
      break;
    case 1:
      peer.reset();
      break;
    default:
      // On WebSocket it is an end without a close frame; no response is required then.
      if (peer.transport() == Transport::kWebSocket) peer.allow_close("half close");
      peer.half_close();
  }
}

void Actions::flood() {
  Peer& peer = random_peer();
  if (random_.percent(80)) peer.read(false);
  static const std::vector<std::string> kMethods{"device.describe", "device.status", "pattern.list",
                                                 "effect.stop_all", "ping"};
  const std::string& method = random_.pick(kMethods);
  const std::size_t count = 50 + random_.below(450);
  for (std::size_t i = 0; i < count; ++i) send(peer, generator_.request(method));
}

void Actions::read_again() {
  for (std::size_t place = 0; place < Traffic::kPlaces; ++place)
    if (Peer* const peer = traffic_.peer(place)) peer->read(true);
}

void Actions::subscribe() {
  Peer& peer = random_peer();
  static const std::vector<std::string> kRequests{"telemetry.subscribe", "telemetry.subscribe",
                                                  "telemetry.unsubscribe", "events.subscribe",
                                                  "events.unsubscribe"};
  const std::string& method = random_.pick(kRequests);
  static const std::vector<std::string> kFields{R"(["state"])", R"(["orientation","effects"])",
                                                R"(["pins"])", R"(["temperature_c","limit_a"])"};
  const std::string fields = random_.pick(kFields);
  const std::string rate = std::to_string(random_.between(1, 200));
  send(peer,
       generator_.request(method, method == "telemetry.subscribe"
                                      ? R"({"rate_hz":)" + rate + R"(,"fields":)" + fields + "}"
                                      : "{}"));
}

void Actions::web_page() {
  const std::size_t place = random_.below(Traffic::kPlaces);
  static const std::vector<std::string> kPaths{"/",
                                               "/metrics",
                                               "/healthz",
                                               "/recordings/trip-0001.hhr",
                                               "/recordings/../state.json",
                                               "/no/such",
                                               "/ws",
                                               "/%2e%2e/%00"};
  std::string request =
      "GET " + random_.pick(kPaths) + " HTTP/1.1\r\nHost: localhost\r\nConnection: close\r\n\r\n";
  if (random_.percent(40)) request = damaged(random_, request);
  if (random_.percent(5)) request = "GET / HTTP/1.1\r\nX: " + std::string(20'000, 'x') + "\r\n\r\n";
  if (Peer* const there = traffic_.peer(place)) there->close();
  traffic_.connect(place, Transport::kHttp, 0).send_bytes(request);
}

void Actions::web_frames() {
  const std::size_t place = random_.below(Traffic::kPlaces);
  Peer& peer = traffic_.connect(place, Transport::kWebSocket, 0);
  const std::string text = generator_.valid();
  switch (random_.below(7)) {
    case 0:
      peer.allow_close("a binary frame");
      peer.send_bytes(web_frame(kBinaryFrame, text));
      break;
    case 1:
      peer.allow_close("a close frame");
      peer.send_bytes(web_frame(kCloseFrame, std::string("\x03\xe8", 2)));
      break;
    case 2:
      peer.send_bytes(web_frame(kPingFrame, random_.bytes(random_.below(126))));
      break;
    case 3:
      peer.allow_close("frames without a mask");
      peer.send_bytes(std::string("\x81\x02{}", 4));
      break;
    case 4:
      peer.allow_close("an unknown kind of frame");
      peer.send_bytes(web_frame(static_cast<int>(3 + random_.below(5)), text));
      break;
    case 5:
      peer.allow_close("a frame of a size that cannot be");
      peer.send_bytes("\x81\xff" + std::string(8, '\x7f') + "mask");
      break;
    default:
      peer.allow_close("random bytes");
      peer.send_bytes(random_.bytes(1 + random_.below(400)));
  }
}

void Actions::foreign_client() {
  const std::size_t place = random_.below(Traffic::kPlaces);
  const Transport transport = random_.percent(50) ? Transport::kTcp : Transport::kUnix;
  std::string first = random_.bytes(1 + random_.below(300));
  static const std::string kRequestStarts = "{[ \t\r\n";
  if (kRequestStarts.find(first[0]) != std::string::npos) first[0] = 'G';
  traffic_.connect_foreign(place, transport, first);
}

void Actions::reload() {
  Configuration next = random_configuration(random_);
  const bool is_good = random_.percent(60);
  if (!is_good) {
    static const std::vector<std::string> kWrong{"{",
                                                 "",
                                                 "[]",
                                                 R"({"limits":{"current_a":"much"}})",
                                                 R"({"no_such":1})",
                                                 R"({"limits":{"current_a":1e999}})",
                                                 R"({"limits":{"current_a":99}})",
                                                 R"({"connections":{"max":0}})",
                                                 "\xff\xfe",
                                                 R"({"http":{"listen":"0.0.0.0:1"}})"};
    next.json = random_.pick(kWrong);
  }
  traffic_.reload(next.json, is_good, next.current_a);
}

void Actions::repair_ball() {
  Peer& peer = random_peer();
  send(peer, generator_.request("sim.set", R"({"fault":{},"errors":[],"ambient_c":25})"));
  send(peer, generator_.request("device.arm"));
  send(peer, generator_.request("effect.hold", R"({"direction":)" + json_string("up") +
                                                   R"(,"slot":"kept","lease_ms":10000})"));
}

}  // namespace hedgehog::soak
