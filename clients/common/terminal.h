// SPDX-License-Identifier: MIT
// The person's terminal: what it can show, keys one by one, and a picture redrawn in place.
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
  /// Colours are wanted (a terminal, and NO_COLOR is not set).
  bool colour = false;
  /// Only ASCII can be shown (the locale is not UTF-8), in a pipe or a file too.
  bool ascii = false;
  /// Lines have a right edge; a pipe and a file have none.
  bool has_edge = false;
};

TerminalTraits terminal_traits();

/// Of stdout, now: a person may change it at any time. Zeros when it is no terminal or has no size.
struct TerminalSize {
  std::size_t columns = 0;
  std::size_t rows = 0;
  friend bool operator==(const TerminalSize&, const TerminalSize&) = default;
};
TerminalSize terminal_size();

/// Both ends of this program are a terminal.
bool is_terminal();

struct Key {
  char what = '\0';
  bool arrow = false;                          // '<' or '>' then
  std::chrono::steady_clock::time_point at{};  // when it came
};

/// Takes the terminal over for a picture: alternate screen, no cursor, keys without echo and line.
/// The destructor gives it back as it was, also when an exception passes. One at a time.
class Terminal {
 public:
  Terminal();
  ~Terminal();
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;

  /// Shows `lines` from the top; only the lines that changed are written, and all of them when the
  /// terminal has another size than before. What is beyond its size is not shown.
  void draw(const std::vector<std::string>& lines);

  /// Every byte typed since the last look, escape sequences too; does not wait. Nothing when stdin
  /// is no terminal.
  std::string typed();
  /// A key within `patience`; of escape sequences only the arrows to left and right.
  std::optional<Key> key(std::chrono::milliseconds patience);
  /// Reads what was typed so far; the time of those keys is the clock's epoch.
  void take_in();
  /// Throws away what was typed so far.
  void forget();

 private:
  bool read_more(std::chrono::milliseconds patience);

  std::vector<std::string> shown_;
  TerminalSize size_{};
  termios before_{};
  bool has_keys_ = false;
  std::string typed_;  // and not yet taken
  std::chrono::steady_clock::time_point typed_at_{};
};

}  // namespace hedgehog::client
