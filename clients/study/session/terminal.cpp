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
  pollfd waiting{STDIN_FILENO, POLLIN, 0};
  if (poll(&waiting, 1, static_cast<int>(patience.count())) != 1) {
    return std::nullopt;
  }
  char bytes[16];
  const ssize_t count = read(STDIN_FILENO, bytes, sizeof bytes);
  if (count <= 0) {
    return std::nullopt;
  }
  const std::string_view typed(bytes, static_cast<std::size_t>(count));
  if (typed == "\033[D" || typed == "\033OD") {
    return '<';
  }
  if (typed == "\033[C" || typed == "\033OC") {
    return '>';
  }
  return typed.front() == '\033' ? std::nullopt : std::optional(typed.front());
}

std::string Terminal::line(const std::string& prompt) {
  keys_one_by_one(false);
  std::printf("\033[%zu;1H\033[K  %s\033[?25h", shown_.size() + 1, prompt.c_str());
  std::fflush(stdout);
  std::string text;
  char byte = 0;
  while (read(STDIN_FILENO, &byte, 1) == 1 && byte != '\n') {
    text += byte;
  }
  std::printf("\033[?25l\033[%zu;1H\033[K", shown_.size() + 1);
  keys_one_by_one(true);
  return text;
}

}  // namespace hedgehog::study
