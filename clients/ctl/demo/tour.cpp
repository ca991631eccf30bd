// SPDX-License-Identifier: MIT
#include "clients/ctl/demo/tour.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace hedgehog::client {

namespace {

using std::chrono::milliseconds;

constexpr milliseconds kRenewal{400};

TourChapter title() {
  return {milliseconds{0},
          milliseconds{2500},
          0,
          "a ball you hold",
          "86 pins; one magnet inside pushes out those on one side. Unrolled here.",
          {}};
}

TourChapter sides() {
  TourChapter chapter{milliseconds{2500},
                      milliseconds{8500},
                      1,
                      "a push has a side",
                      "A crash on one side: pins push into the palm there.",
                      {}};
  milliseconds at = chapter.from;
  for (const char* side : {"left", "right", "front", "back", "up", "down"}) {
    chapter.steps.push_back(
        {at, "effect.pulse",
         R"({"direction":")" + std::string(side) + R"(","current_a":10,"duration_ms":400})",
         "pulse " + std::string(side)});
    at += milliseconds{1000};
  }
  return chapter;
}

TourChapter circle() {
  return {milliseconds{8500},
          milliseconds{14500},
          2,
          "the circle of the study",
          "A turn in 1.5 s, at the current that can flow for ever.",
          {{milliseconds{8500}, "effect.circle",
            R"({"speed_pins_s":10,"current_a":5,"duration_ms":5900})", "circle 10 pins/s"}}};
}

TourChapter skid() {
  return {milliseconds{14500},
          milliseconds{18500},
          3,
          "skidding",
          "A road that shakes from below: 60 pushes a second.",
          {{milliseconds{14500}, "effect.vibrate",
            R"({"direction":"down","frequency_hz":60,"current_a":8,"duration_ms":3900})",
            "vibrate down"}}};
}

/// Holds `params` from `from` to `to` in `slot`: renews its lease, then stops it.
void hold(TourChapter& chapter, const std::string& slot, const std::string& params,
          const std::string& words) {
  chapter.steps.push_back({chapter.from, "effect.hold",
                           "{" + params + R"(,"lease_ms":10000,"slot":")" + slot + R"("})", words});
  const std::string slot_only = R"({"slot":")" + slot + R"("})";
  for (milliseconds at = chapter.from + kRenewal; at < chapter.to - kRenewal; at += kRenewal)
    chapter.steps.push_back({at, "effect.update", slot_only, "", false});
  chapter.steps.push_back({chapter.to - milliseconds{50}, "effect.stop", slot_only, "", false});
}

/// Rotates the ball to its right by 120 degrees and back.
void roll(TourChapter& chapter) {
  constexpr milliseconds kPeriod{40};
  const milliseconds first = chapter.from + milliseconds{500};
  const double span = static_cast<double>((chapter.to - milliseconds{500} - first).count());
  for (milliseconds at = first; at <= chapter.to - milliseconds{500}; at += kPeriod) {
    const double part = static_cast<double>((at - first).count()) / span;
    const double angle = 120.0 * 0.5 * (1.0 - std::cos(2.0 * std::numbers::pi * part));
    const double half = angle * std::numbers::pi / 360.0;
    chapter.steps.push_back(
        {at, "sim.set",
         fmt::format(R"({{"orientation":{{"w":{:.6f},"x":{:.6f},"y":0,"z":0}}}})", std::cos(half),
                     std::sin(half)),
         "", false});
  }
}

TourChapter compass(bool simulated) {
  TourChapter chapter{
      milliseconds{18500},
      milliseconds{25500},
      4,
      "up stays up",
      simulated ? "The ball is turned. The triangle is up in the room; the push stays there."
                : "Turn the ball. The triangle is up in the room; the push stays there.",
      {}};
  hold(chapter, "up", R"("direction":"up","frame":"world","current_a":5)", "hold up");
  if (simulated) roll(chapter);
  return chapter;
}

TourChapter heat() {
  TourChapter chapter{milliseconds{25500},
                      milliseconds{34500},
                      5,
                      "heat",
                      "15 A asked for 9 s. It is derated as it gets warm, and never cut off.",
                      {}};
  hold(chapter, "push", R"("direction":"up","current_a":15)", "hold up");
  return chapter;
}

TourChapter rest() {
  return {milliseconds{34500},
          milliseconds{38000},
          0,
          "rest",
          "Nothing plays. The current that is allowed climbs again.",
          {}};
}

}  // namespace

std::vector<TourChapter> tour(bool simulated) {
  std::vector<TourChapter> chapters{title(), sides(), circle(), skid(), compass(simulated),
                                    heat(),  rest()};
  for (TourChapter& chapter : chapters) {
    std::stable_sort(
        chapter.steps.begin(), chapter.steps.end(),
        [](const TourStep& a, const TourStep& b) { return a.at < b.at; });
  }
  return chapters;
}

}  // namespace hedgehog::client
