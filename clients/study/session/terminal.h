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

/// Restores the terminal when it goes away. One at a time.
class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  void draw(const std::vector<std::string>& lines);
  /// A key within `patience`; the arrows are '<' and '>'.
  std::optional<char> key(std::chrono::milliseconds patience);
  /// A line typed with echo below the picture.
  std::string line(const std::string& prompt);

 private:
  void keys_one_by_one(bool on);

  termios before_{};
  std::vector<std::string> shown_{};
  std::string typed_{};  // and not yet taken
};

}  // namespace hedgehog::study
