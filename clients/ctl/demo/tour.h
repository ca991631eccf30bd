// SPDX-License-Identifier: MIT
// The tour of the demo as data: five chapters, and the requests that play them at their times.
#pragma once

#include <chrono>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::client {

using Milliseconds = std::chrono::milliseconds;

/// One request of the tour, sent as it is shown.
struct TourStep {
  Milliseconds at{};
  std::string method;
  /// The parameters as JSON text.
  std::string params;
  /// What is told of it: "pulse left".
  std::string words;
  /// False: it only keeps something going (a renewed lease, a turn of the simulated ball).
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

/// At most 40 seconds. On a simulated ball the tour turns it; a real one is turned by the person
/// who holds it.
std::vector<TourChapter> tour(bool simulated);

}  // namespace hedgehog::client
