// SPDX-License-Identifier: MIT
#include "clients/ctl/verbs/live.h"

#include <cstdio>
#include <ctime>

#include "clients/ctl/screen/terminal.h"

namespace hedgehog::client {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kGlance{50};
constexpr milliseconds kGlanceWithKeys{20};

/// False: the person wants to leave.
bool press(char key, Session& session) {
  if (key == ' ') {
    // Unanswered: the stop must not wait behind whatever the socket still holds.
    (void)session.connection.notify(protocol::DeviceEmergencyStop{});
  }
  return key != 'q';
}

int draw_until_left(Session& session,
                    const std::function<std::vector<std::string>(const Notification&)>& draw) {
  Canvas canvas;
  while (!interrupted()) {
    auto told = session.connection.next(kGlanceWithKeys);
    if (!told) {
      return exit_code_of(told.error());
    }
    if (*told) {
      if (const std::vector<std::string> lines = draw(**told); !lines.empty()) {
        canvas.draw(lines);
      }
    }
    if (const auto key = canvas.key(milliseconds{0}); key && !press(*key, session)) {
      return kDone;
    }
  }
  return kInterrupted;
}

}  // namespace

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[16];
  std::strftime(text, sizeof text, "%H:%M:%S", &local);
  return text;
}

int follow(Session& session, const std::function<bool(const Notification&)>& take) {
  while (!interrupted()) {
    auto told = session.connection.next(kGlance);
    if (!told) {
      return complain(told.error());
    }
    if (*told && !take(**told)) {
      return kDone;
    }
  }
  return kInterrupted;
}

int follow_drawing(Session& session,
                   const std::function<std::vector<std::string>(const Notification&)>& draw) {
  const int code = draw_until_left(session, draw);
  if (code == kUnavailable) {
    std::fputs("hedgehogctl: the daemon ended the connection\n", stderr);
  }
  return code;
}

}  // namespace hedgehog::client
