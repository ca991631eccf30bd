// SPDX-License-Identifier: MIT
#include "clients/ctl/terminal/terminal.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace hedgehog::client {

namespace {

constexpr int kMinColumns = 80;
constexpr int kMinRows = 22;

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value == nullptr ? std::string_view{} : std::string_view{value};
}

bool locale_is_utf8() {
  for (const char* name : {"LC_ALL", "LC_CTYPE", "LANG"}) {
    const std::string_view value = environment(name);
    if (!value.empty()) {
      return value.find("UTF-8") != std::string_view::npos ||
             value.find("utf8") != std::string_view::npos;
    }
  }
  return false;
}

void put(std::string_view text) { std::fwrite(text.data(), 1, text.size(), stdout); }

}  // namespace

TerminalTraits terminal_traits() {
  TerminalTraits traits;
  traits.ascii = !locale_is_utf8();
  if (isatty(STDOUT_FILENO) == 0) {
    // A pipe or a file takes UTF-8 whatever the locale of the session is.
    traits.ascii = false;
    return traits;
  }
  const bool dumb = environment("TERM").empty() || environment("TERM") == "dumb";
  traits.colour = !dumb && environment("NO_COLOR").empty();
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  traits.picture = !dumb && known && size.ws_col >= kMinColumns && size.ws_row >= kMinRows;
  return traits;
}

Canvas::Canvas() {
  has_keys_ = tcgetattr(STDIN_FILENO, &before_) == 0;
  if (has_keys_) {
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  put("\033[?1049h\033[?25l\033[2J");
  std::fflush(stdout);
}

Canvas::~Canvas() {
  put("\033[?25h\033[?1049l");
  std::fflush(stdout);
  if (has_keys_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

void Canvas::draw(const std::vector<std::string>& lines) {
  for (std::size_t row = 0; row < lines.size() || row < shown_.size(); ++row) {
    const std::string_view line = row < lines.size() ? std::string_view{lines[row]} : "";
    if (row < shown_.size() && shown_[row] == line) continue;
    std::printf("\033[%zu;1H", row + 1);
    put(line);
    put("\033[K");
  }
  shown_ = lines;
  std::fflush(stdout);
}

std::string Canvas::typed() {
  std::string keys;
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  while (has_keys_ && poll(&waiting, 1, 0) == 1) {
    char bytes[64];
    const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) break;
    keys.append(bytes, static_cast<std::size_t>(count));
  }
  return keys;
}

}  // namespace hedgehog::client
