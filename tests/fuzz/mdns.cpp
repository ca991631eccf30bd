// SPDX-License-Identifier: MIT
// Arbitrary bytes as responses to the discovery of balls: the results are printable, bounded, and
// requested in a query that fits into a datagram.
#include <algorithm>
#include <cstdlib>
#include <string>
#include <string_view>

#include "clients/lib/discovery/choice.h"
#include "clients/lib/discovery/mdns_answers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace hedgehog::client;
  const auto is_plain = [](const std::string& text) {
    for (std::size_t i = 0; i < text.size(); ++i) {
      const auto byte = static_cast<unsigned char>(text[i]);
      // C1 control characters are C2 80 to C2 9F in UTF-8.
      const bool c1 = byte == 0xc2u && static_cast<unsigned char>(text.at(i + 1)) < 0xa0u;
      if (byte < 0x20u || byte == 0x7fu || c1) return false;
    }
    return true;
  };
  // The id used by the seeds. A second response is the end of the first, from the offset in its
  // first byte.
  mdns::Answers answers(0x1234);
  const std::string_view packet(reinterpret_cast<const char*>(data), size);
  answers.read(packet);
  if (size > 0) answers.read(packet.substr(std::min<std::size_t>(data[0], size)));
  if (answers.query().size() > 1200) std::abort();
  const auto balls = answers.balls();
  for (const DiscoveredBall& ball : balls) {
    const bool complete =
        !ball.name.empty() && ball.address.port != 0 && !ball.address.host.empty();
    if (!complete || !is_plain(ball.name) || !is_plain(ball.host) ||
        !is_plain(ball.serial.value_or("")) || !is_plain(ball.protocol.value_or("")))
      std::abort();
    const auto chosen = chosen_ball(ball.name, balls);
    if (chosen.has_value() != ball.address.tls &&
        named_balls(ball.name, balls).empty() == chosen.has_value())
      std::abort();
  }
  return 0;
}
