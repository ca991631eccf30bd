// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/live.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <utility>

#include "base/wall_time.h"
#include "clients/common/interrupts.h"
#include "clients/common/terminal.h"
#include "clients/ctl/screen/status_screen.h"
#include "clients/ctl/terminal/words.h"

namespace hedgehog::client {

namespace {

using std::chrono::milliseconds;

constexpr std::size_t kMinColumns = 80;
constexpr std::size_t kMinRows = 22;
constexpr milliseconds kEventPoll{50};
constexpr milliseconds kKeyPoll{20};
/// Without messages for this long the daemon is reported as silent; it sends ten per second.
constexpr milliseconds kSilent{2000};
/// Timeout of the response to a stop.
constexpr milliseconds kAnswers{1000};

/// Whether the picture is current, and whether the stop has been acknowledged.
class Liveness {
 public:
  using Clock = std::chrono::steady_clock;

  explicit Liveness(Connection& connection) : connection_(connection) {}

  void received() { received_at_ = Clock::now(); }
  /// Does not wait for the response, which may be queued behind other messages in the socket.
  void stop() {
    (void)connection_.request(protocol::DeviceEmergencyStop{});
    if (!unanswered_) stopped_at_ = Clock::now();
    unanswered_ = true;
  }
  /// The warning to be shown; empty: none.
  std::string warning() {
    while (connection_.response()) unanswered_ = false;
    const auto now = Clock::now();
    if (unanswered_ && now - stopped_at_ > kAnswers) return "stop sent, no answer: pull the plug";
    return now - received_at_ > kSilent ? "no data from hedgehogd: the values are out of date" : "";
  }

 private:
  Connection& connection_;
  Clock::time_point received_at_ = Clock::now();
  Clock::time_point stopped_at_{};
  bool unanswered_ = false;  // valid since that time
};

/// False: quit.
bool press(const std::string& keys, Liveness& liveness) {
  // A space is a stop whatever else is typed; `q` quits only outside of an escape sequence, where
  // it is a key of the number pad.
  if (keys.find(' ') != std::string::npos) liveness.stop();
  return keys.find('q') == std::string::npos || keys.find('\033') != std::string::npos;
}

int draw_until_quit(Session& session,
                    const std::function<std::vector<std::string>(const Notification&)>& draw) {
  Terminal terminal;
  Liveness liveness(session.connection);
  std::vector<std::string> lines;
  while (!interrupted()) {
    auto notification = session.connection.next(kKeyPoll);
    if (!notification) return exit_code_of(notification.error());
    if (*notification) {
      liveness.received();
      if (std::vector<std::string> fresh = draw(**notification); !fresh.empty())
        lines = std::move(fresh);
    }
    std::vector<std::string> shown = lines;
    if (const std::string warning = liveness.warning(); !warning.empty()) {
      shown.resize(std::max(shown.size(), std::size_t{1}));
      ScreenStyle style = session.style;
      style.columns = live_size().columns;
      shown.front() = warning_title(warning, style);
    }
    terminal.draw(shown);
    if (!press(terminal.typed(), liveness)) return kDone;
  }
  return kInterrupted;
}

}  // namespace

std::string time_of_day() { return local_time(base::rfc3339(base::unix_ms_now()), "%H:%M:%S"); }

TerminalSize live_size() {
  const TerminalSize size = terminal_size();
  return {.columns = std::max(kMinColumns, size.columns), .rows = std::max(kMinRows, size.rows)};
}

int follow(Session& session, const std::function<bool(const Notification&)>& take,
           const std::function<void()>& idle) {
  while (!interrupted()) {
    idle();
    auto notification = session.connection.next(kEventPoll);
    if (!notification) return report_error(notification.error());
    if (*notification && !take(**notification)) return kDone;
  }
  return kInterrupted;
}

int follow_drawing(Session& session,
                   const std::function<std::vector<std::string>(const Notification&)>& draw) {
  const int code = draw_until_quit(session, draw);
  if (code == kUnavailable) print_failure("closed", "the daemon ended the connection");
  return code;
}

}  // namespace hedgehog::client
