// SPDX-License-Identifier: MIT
#include <poll.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <string>

#include "cli/program.h"
#include "clients/common/arguments.h"
#include "clients/common/exit_code.h"
#include "clients/common/interrupts.h"
#include "clients/common/text.h"
#include "clients/lib/backoff.h"
#include "clients/lib/client_error.h"
#include "clients/lib/connection.h"
#include "clients/orientation/indicator.h"
#include "model/geometry/direction.h"

namespace {

using namespace hedgehog;
using namespace hedgehog::client;
using std::chrono::milliseconds;

void print(const IndicatorReport& report) {
  if (!report.up) {
    std::puts("up is not known: the orientation sensor is silent");
  } else {
    const std::string side(hedgehog::model::side_name(*report.up));
    const std::string warm = temperature_words(report.temperature_c);
    if (report.pin) {
      std::printf("up is %-5s   %.3f N at pin %lld   %s\n", side.c_str(), report.force_n,
                  static_cast<long long>(*report.pin), warm.c_str());
    } else {
      std::printf("up is %-5s   at rest between two pulses   %s\n", side.c_str(), warm.c_str());
    }
  }
  std::fflush(stdout);
}

/// Waits for `time`, or until the program is interrupted.
void pause_for(milliseconds time) {
  constexpr milliseconds kSlice{100};
  for (; time.count() > 0 && !interrupted(); time -= kSlice)
    ::poll(nullptr, 0, static_cast<int>(std::min(time, kSlice).count()));
}

/// Resets `backoff` once the effect plays, not once it is connected: a daemon that closes each
/// connection at once is tried no more often than an absent one.
Outcome<void> indicate(Outcome<Connection>& opened, const IndicatorOptions& options,
                       Backoff& backoff) {
  if (!opened) return opened.error();
  Connection& connection = *opened;
  if (const auto hello = connection.hello("hedgehog-orientation/" HEDGEHOG_VERSION); !hello)
    return hello.error();
  return Indicator(connection, options).run(interrupted, [&](const IndicatorReport& report) {
    backoff.reset();
    print(report);
  });
}

int run(const std::vector<Address>& addresses, const IndicatorOptions& options, bool wait) {
  Backoff backoff;
  auto connection = Connection::open(addresses);
  for (;;) {
    const auto outcome = indicate(connection, options, backoff);
    if (interrupted()) return kInterrupted;
    if (outcome) return 0;
    std::fprintf(stderr, "hedgehog-orientation: %s\n", outcome.error().message.c_str());
    if (!wait || !may_connect_later(outcome.error())) return kUnavailable;
    std::fputs("hedgehog-orientation: waiting for the daemon\n", stderr);
    auto pause = retry_after(outcome.error());
    do {
      pause_for(std::max(pause, backoff.next()));
      if (interrupted()) return kInterrupted;
      connection = Connection::open(addresses);
      pause = connection ? milliseconds(0) : retry_after(connection.error());
    } while (!connection && may_connect_later(connection.error()));
  }
}

}  // namespace

int main(int argc, char** argv) {
  cli::Program app{"Plays an effect towards up while the ball is turned.", "hedgehog-orientation"};
  IndicatorOptions options;
  std::optional<std::string> address;
  std::optional<double> seconds;
  bool once = false;
  app.set_version(std::string("hedgehog-orientation " HEDGEHOG_VERSION));
  std::string loop = "daemon";
  std::string style = "pulse";
  app.add_option("--loop", loop, "what follows the orientation: client or daemon")
      .one_of({"client", "daemon"})
      .show_default();
  app.add_option("--style", style, "pulse (felt better) or steady (5 A)")
      .one_of({"pulse", "steady"})
      .show_default();
  app.add_option("--address", address, "host:port or a socket's path (HEDGEHOG_ADDRESS)");
  app.add_option("--seconds", seconds, "ends after this time instead of at Ctrl-C").positive();
  app.add_flag("--once", once, "ends with the connection instead of reconnecting");
  if (const auto code = parse_arguments(app, argc, argv)) return *code;
  options.loop = loop == "client" ? Loop::kClient : Loop::kDaemon;
  options.style = style == "steady" ? Style::kSteady : Style::kPulse;
  if (seconds) options.duration = milliseconds(static_cast<std::int64_t>(*seconds * 1000.0));
  watch_interrupts();
  const auto addresses = daemon_addresses(address);
  if (!addresses) {
    std::fprintf(stderr, "hedgehog-orientation: %s\n", addresses.error().message.c_str());
    return kUsage;
  }
  return run(*addresses, options, !once);
}
