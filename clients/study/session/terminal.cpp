// SPDX-License-Identifier: MIT
#include "clients/study/session/terminal.h"

#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <string_view>
#include <utility>

namespace hedgehog::study {

bool is_terminal() { return isatty(STDIN_FILENO) != 0 && isatty(STDOUT_FILENO) != 0; }

Terminal::Terminal() {
  tcgetattr(STDIN_FILENO, &before_);
  keys_one_by_one(true);
  std::fputs("\033[?1049h\033[?25l\033[2J", stdout);
  std::fflush(stdout);
}

Terminal::~Terminal() {
  std::fputs("\033[?25h\033[?1049l", stdout);
  std::fflush(stdout);
  keys_one_by_one(false);
}

void Terminal::keys_one_by_one(bool on) {
  termios mode = before_;
  if (on) {
    mode.c_lflag &= ~static_cast<tcflag_t>(ICANON | ECHO);
  }
  tcsetattr(STDIN_FILENO, TCSANOW, &mode);
}

void Terminal::draw(const std::vector<std::string>& lines) {
  for (std::size_t row = 0; row < lines.size() || row < shown_.size(); ++row) {
    const std::string_view line = row < lines.size() ? std::string_view{lines[row]} : "";
    if (row < shown_.size() && shown_[row] == line) {
      continue;
    }
    std::printf("\033[%zu;1H%.*s\033[K", row + 1, static_cast<int>(line.size()), line.data());
  }
  shown_ = lines;
  std::fflush(stdout);
}

std::optional<char> Terminal::key(std::chrono::milliseconds patience) {
  if (typed_.empty()) {
    pollfd waiting{STDIN_FILENO, POLLIN, 0};
    char bytes[64];
    if (poll(&waiting, 1, static_cast<int>(patience.count())) != 1) {
      return std::nullopt;
    }
    const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
    if (count <= 0) {
      return std::nullopt;
    }
    typed_.assign(bytes, static_cast<std::size_t>(count));
  }
  // Several keys may come in one breath.
  const char first = typed_.front();
  const bool sequence =
      first == '\033' && typed_.size() >= 3 && (typed_[1] == '[' || typed_[1] == 'O');
  const char last = sequence ? typed_[2] : '\0';
  typed_.erase(0, sequence ? 3 : 1);
  if (last == 'D' || last == 'C') {
    return last == 'D' ? '<' : '>';
  }
  return first == '\033' ? std::nullopt : std::optional(first);
}

std::string Terminal::line(const std::string& prompt) {
  keys_one_by_one(false);
  std::printf("\033[%zu;1H\033[K  %s\033[?25h", shown_.size() + 1, prompt.c_str());
  std::fflush(stdout);
  std::string text = std::exchange(typed_, {});
  char byte = 0;
  while (text.find('\n') == std::string::npos && read(STDIN_FILENO, &byte, 1) == 1) {
    text += byte;
  }
  text = text.substr(0, text.find('\n'));
  std::printf("\033[?25l\033[%zu;1H\033[K", shown_.size() + 1);
  keys_one_by_one(true);
  return text;
}

}  // namespace hedgehog::study
