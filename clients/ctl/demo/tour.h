// SPDX-License-Identifier: MIT
// The tour of the demo as data: five chapters and their timed requests.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::client {

using Milliseconds = std::chrono::milliseconds;

/// One request of the tour, shown when it is sent.
struct TourStep {
  Milliseconds at{};
  std::string method;
  /// The parameters as JSON text.
  std::string params;
  /// Its description: "pulse left".
  std::string words;
  /// False: a request in the background (renewal of a lease, a rotation of the simulated ball).
  bool shown = true;
};

struct TourChapter {
  Milliseconds from{};
  Milliseconds to{};
  /// 1..5; 0 for the title and the rest at the end.
  int number = 0;
  std::string title;
  std::string caption;
  std::vector<TourStep> steps;
};

inline constexpr int kTourChapters = 5;

/// At most 40 seconds. A simulated ball is rotated by the tour, a real one by the user.
std::vector<TourChapter> tour(bool simulated);

}  // namespace hedgehog::client
