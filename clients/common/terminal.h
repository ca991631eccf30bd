// SPDX-License-Identifier: MIT
// The user's terminal: its capabilities, single keys, and a picture redrawn in place.
#pragma once

#include <termios.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace hedgehog::client {

struct TerminalTraits {
  /// A picture can be redrawn in place: stdout is a terminal of at least 80x22 that is not dumb.
  bool picture = false;
  /// Colours are enabled (a terminal, and NO_COLOR is not set).
  bool colour = false;
  /// Only ASCII can be printed (the locale is not UTF-8), to a pipe or a file too.
  bool ascii = false;
  /// Lines have a limited width; false: a pipe or a file.
  bool has_edge = false;
};

TerminalTraits terminal_traits();

/// Current size of stdout, which may change at any time. Zeros if it is not a terminal or has no
/// size.
struct TerminalSize {
  std::size_t columns = 0;
  std::size_t rows = 0;
  friend bool operator==(const TerminalSize&, const TerminalSize&) = default;
};
TerminalSize terminal_size();

/// True if stdin and stdout are a terminal.
bool is_terminal();

struct Key {
  char what = '\0';
  bool arrow = false;                          // `what` is then '<' or '>'
  std::chrono::steady_clock::time_point at{};  // when it was read
};

/// Takes over the terminal for a picture: alternate screen, no cursor, keys without echo and line
/// editing. The destructor restores its state, also after an exception. One instance at a time.
class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Draws `lines` from the top; only the lines that changed are written, or all of them after a
  /// change of the terminal's size. What is beyond its size is not drawn.
  void draw(const std::vector<std::string>& lines);

  /// All bytes typed since the last call, escape sequences included; does not block. Nothing if
  /// stdin is not a terminal.
  std::string typed();
  /// A key within `timeout`; of escape sequences only the left and right arrows.
  std::optional<Key> key(std::chrono::milliseconds timeout);
  /// Reads the keys typed so far; their time is the clock's epoch.
  void take_in();
  /// Discards the keys typed so far.
  void discard_keys();

 private:
  bool read_more(std::chrono::milliseconds timeout);

  std::vector<std::string> shown_;
  TerminalSize size_{};
  termios before_{};
  bool has_keys_ = false;
  std::string typed_;  // read and not returned yet
  std::chrono::steady_clock::time_point typed_at_{};
};

}  // namespace hedgehog::client
