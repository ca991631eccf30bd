// SPDX-License-Identifier: MIT
// An X server without a display (Xvfb), and the picture that its clients have drawn.
#pragma once

#include <string>

#include "tests/vm/bench.h"

namespace hedgehog::vm {

/// The pixels of a screen, row by row, four bytes each.
using Picture = std::string;

/// The share of pixels that are not black; of a sample of them, as the next.
double lit_share(const Picture& picture);
/// The share of pixels that differ visibly between two pictures of one screen.
double changed_share(const Picture& before, const Picture& after);

class Screen {
 public:
  static constexpr int kWidth = 320;
  static constexpr int kHeight = 240;

  /// Throws when the server does not start. `home`: where its frame buffer is.
  explicit Screen(const Home& home);

  /// NAME=VALUE for its clients.
  static std::string display();
  /// As of now.
  Picture picture() const;
  /// Asks all windows to close, as a person does by a click on their corner. What went wrong;
  /// empty: nothing did.
  std::string close_windows() const;

 private:
  const Home& home_;
  Child server_;
};

}  // namespace hedgehog::vm
