// SPDX-License-Identifier: MIT
// An X server without a display (Xvfb), and the picture that its clients have drawn.
#pragma once

#include <string>

#include "tests/vm/bench.h"

namespace hedgehog::vm {

/// The pixels of a screen, row by row, four bytes each.
using Picture = std::string;

/// The share of pixels that are not black; from a sample of them, as in `changed_share`.
double lit_share(const Picture& picture);
/// The share of pixels that differ visibly between two pictures of one screen.
double changed_share(const Picture& before, const Picture& after);

class Screen {
 public:
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;

  /// Throws when the server does not start. `home`: the folder of its frame buffer.
  explicit Screen(const Home& home);

  /// NAME=VALUE for its clients.
  static std::string display();
  /// The current picture.
  Picture picture() const;
  /// Requests all windows to close, as a person does by a click on their close button. Returns the
  /// error, or an empty string.
  std::string close_windows() const;

 private:
  const Home& home_;
  Child server_;
};

}  // namespace hedgehog::vm
