// SPDX-License-Identifier: MIT
#include "clients/study/session/terminal.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>

namespace hedgehog::study {

bool is_terminal() { return isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0; }

Terminal::Terminal() {
  tcgetattr(STDIN_FILENO, &before_);
  termios mode = before_;
  mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  tcsetattr(STDIN_FILENO, TCSANOW, &mode);
  std::fputs("\033[?1049h\033[?25l\033[2J", stdout);
  std::fflush(stdout);
}

Terminal::~Terminal() {
  std::fputs("\033[?25h\033[?1049l", stdout);
  std::fflush(stdout);
  tcsetattr(STDIN_FILENO, TCSANOW, &before_);
}

void Terminal::draw(const std::vector<std::string>& lines) {
  for (std::size_t row = 0; row < lines.size() || row < shown_.size(); ++row) {
    const std::string_view line = row < lines.size() ? std::string_view{lines[row]} : "";
    if (row < shown_.size() && shown_[row] == line) continue;
    std::printf("\033[%zu;1H%.*s\033[K", row + 1, static_cast<int>(line.size()), line.data());
  }
  shown_ = lines;
  std::fflush(stdout);
}

bool Terminal::read_more(std::chrono::milliseconds patience) {
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  char bytes[64];
  if (poll(&waiting, 1, static_cast<int>(patience.count())) != 1) return false;
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

void Terminal::forget() {
  take_in();
  typed_.clear();
}

std::optional<Key> Terminal::key(std::chrono::milliseconds patience) {
  if (typed_.empty() && !read_more(patience)) return std::nullopt;
  // Several keys may come in one breath.
  const char first = typed_.front();
  const bool sequence =
      first == '\033' && typed_.size() >= 3 && (typed_[1] == '[' || typed_[1] == 'O');
  const char last = sequence ? typed_[2] : '\0';
  typed_.erase(0, sequence ? 3 : 1);
  if (last == 'D' || last == 'C') return Key{last == 'D' ? '<' : '>', true, typed_at_};
  return first == '\033' ? std::nullopt : std::optional(Key{first, false, typed_at_});
}

}  // namespace hedgehog::study
