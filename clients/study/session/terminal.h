// SPDX-License-Identifier: MIT
// A terminal taken over for a picture and single keys.
#pragma once

#include <termios.h>

#include <chrono>
#include <optional>
#include <string>
#include <vector>

namespace hedgehog::study {

/// Both ends of this program are a terminal.
bool is_terminal();

struct Key {
  char what = '\0';
  bool arrow = false;                          // '<' or '>' then
  std::chrono::steady_clock::time_point at{};  // when it came
};

/// Restores the terminal when it goes away. One at a time.
class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void draw(const std::vector<std::string>& lines);
  /// A key within `patience`.
  std::optional<Key> key(std::chrono::milliseconds patience);
  /// Reads what was typed so far; the time of those keys is the clock's epoch.
  void take_in();
  /// Throws away what was typed so far.
  void forget();

 private:
  bool read_more(std::chrono::milliseconds patience);

  termios before_{};
  std::vector<std::string> shown_{};
  std::string typed_{};  // and not yet taken
  std::chrono::steady_clock::time_point typed_at_{};
};

}  // namespace hedgehog::study
