// SPDX-License-Identifier: MIT
#include "clients/common/terminal.h"

#include <poll.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace hedgehog::client {

namespace {

constexpr std::size_t kMinColumns = 80;
constexpr std::size_t kMinRows = 22;

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

bool is_terminal() { return isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0; }

TerminalTraits terminal_traits() {
  TerminalTraits traits;
  traits.ascii = !locale_is_utf8();
  traits.has_edge = isatty(STDOUT_FILENO) != 0;
  if (!traits.has_edge) return traits;
  const bool dumb = environment("TERM").empty() || environment("TERM") == "dumb";
  traits.colour = !dumb && environment("NO_COLOR").empty();
  const TerminalSize size = terminal_size();
  traits.picture = !dumb && size.columns >= kMinColumns && size.rows >= kMinRows;
  return traits;
}

TerminalSize terminal_size() {
  winsize size{};
  if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) != 0) return {};
  return {size.ws_col, size.ws_row};
}

Terminal::Terminal() {
  has_keys_ = tcgetattr(STDIN_FILENO, &before_) == 0;
  if (has_keys_) {
    termios raw = before_;
    raw.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
    tcsetattr(STDIN_FILENO, TCSANOW, &raw);
  }
  size_ = terminal_size();
  // Without line wrap: long lines are cut at the edge of a terminal that was made narrower.
  put("\033[?1049h\033[?25l\033[?7l\033[2J");
  std::fflush(stdout);
}

Terminal::~Terminal() {
  put("\033[?7h\033[?25h\033[?1049l");
  std::fflush(stdout);
  if (has_keys_) tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

void Terminal::draw(const std::vector<std::string>& lines) {
  // Queried each time, which takes less than 1 µs: no signal can be missed.
  if (const TerminalSize size = terminal_size(); size != size_) {
    size_ = size;
    shown_.clear();
    put("\033[2J");
  }
  const std::size_t rows = size_.rows > 0 ? size_.rows : lines.size() + shown_.size();
  for (std::size_t row = 0; row < std::min(rows, std::max(lines.size(), shown_.size())); ++row) {
    const std::string_view line = row < lines.size() ? std::string_view{lines[row]} : "";
    if (row < shown_.size() && shown_[row] == line) continue;
    // Erased first: after a line of the full width the cursor is still in the last column.
    std::printf("\033[%zu;1H\033[K", row + 1);
    put(line);
  }
  shown_ = lines;
  std::fflush(stdout);
}

bool Terminal::read_more(std::chrono::milliseconds timeout) {
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  char bytes[64];
  if (poll(&waiting, 1, static_cast<int>(timeout.count())) != 1) return false;
  const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
  if (count <= 0) return false;
  typed_.append(bytes, static_cast<std::size_t>(count));
  typed_at_ = std::chrono::steady_clock::now();
  return true;
}

void Terminal::take_in() {
  while (read_more(std::chrono::milliseconds{0})) {
  }
  typed_at_ = {};
}

void Terminal::discard_keys() {
  take_in();
  typed_.clear();
}

std::string Terminal::typed() {
  if (has_keys_) take_in();
  return std::exchange(typed_, {});
}

std::optional<Key> Terminal::key(std::chrono::milliseconds timeout) {
  if (typed_.empty() && !read_more(timeout)) return std::nullopt;
  // One read may return several keys.
  const char first = typed_.front();
  const bool sequence =
      first == '\033' && typed_.size() >= 3 && (typed_[1] == '[' || typed_[1] == 'O');
  const char last = sequence ? typed_[2] : '\0';
  typed_.erase(0, sequence ? 3 : 1);
  if (last == 'D' || last == 'C') return Key{last == 'D' ? '<' : '>', true, typed_at_};
  return first == '\033' ? std::nullopt : std::optional(Key{first, false, typed_at_});
}

}  // namespace hedgehog::client
