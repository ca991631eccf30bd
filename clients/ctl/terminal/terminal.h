// SPDX-License-Identifier: MIT
// The person's terminal: what it can show, keys one by one, and a picture redrawn in place.
#pragma once

#include <termios.h>

#include <string>
#include <vector>

namespace hedgehog::client {

struct TerminalTraits {
  /// A picture can be redrawn in place: stdout is a terminal of at least 80x22 that is not dumb.
  bool picture = false;
  /// Colours are wanted (a terminal, and NO_COLOR is not set).
  bool colour = false;
  /// Only ASCII can be shown (the locale is not UTF-8).
  bool ascii = false;
};

TerminalTraits terminal_traits();

/// Takes the terminal over for a picture: alternate screen, no cursor, keys without echo and line.
/// The destructor gives it back as it was, also when an exception passes. One at a time.
class Canvas {
 public:
  Canvas();
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;

  /// Shows `lines` from the top; only the lines that changed are written.
  void draw(const std::vector<std::string>& lines);

  /// Every byte typed since the last look, escape sequences too; does not wait.
  std::string typed();

 private:
  std::vector<std::string> shown_;
  termios before_{};
  bool has_keys_ = false;
};

}  // namespace hedgehog::client
