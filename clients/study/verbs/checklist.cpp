// SPDX-License-Identifier: MIT
#include "clients/study/verbs/checklist.h"

#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <string>

namespace hedgehog::study {

namespace {

constexpr double kSmallestHandCm = 10.0;
constexpr double kLargestHandCm = 30.0;

std::optional<std::string> asked(const char* question) {
  std::printf("%s ", question);
  std::fflush(stdout);
  std::string answer;
  if (!std::getline(std::cin, answer)) return std::nullopt;
  return answer;
}

bool ticked(bool& given, const char* question) {
  if (!given) {
    const auto answer = asked(question);
    given = answer && !answer->empty() && (answer->front() == 'y' || answer->front() == 'Y');
  }
  return given;
}

bool filled(std::string& given, const char* question, bool needed) {
  while (given.empty()) {
    const auto answer = asked(question);
    if (!answer) return false;
    given = *answer;
    if (!needed) break;
  }
  return true;
}

bool ready(Checklist& given) {
  return ticked(given.headphones, "noise-cancelling headphones on and running? [y/n]") &&
         ticked(given.hand_on_top, "dominant hand on top of the ball, relaxed? [y/n]");
}

}  // namespace

std::optional<Checklist> complete(Checklist given) {
  if (!filled(given.experimenter, "experimenter (a code, not a name):", true) ||
      !filled(given.consent, "consent sheet, its reference:", true) ||
      !filled(given.age_band, "age band (22-29; Enter: not said):", false))
    return std::nullopt;
  while (given.dominant_hand != "left" && given.dominant_hand != "right") {
    given.dominant_hand.clear();
    if (!filled(given.dominant_hand, "dominant hand (left, right):", true)) return std::nullopt;
  }
  while (!given.hand_size_cm) {
    const auto answer = asked("hand, tip of the index finger to the wrist, in cm:");
    if (!answer) return std::nullopt;
    const double size = std::strtod(answer->c_str(), nullptr);
    if (size >= kSmallestHandCm && size <= kLargestHandCm)
      given.hand_size_cm = size;
    else
      std::printf("between %.0f and %.0f cm\n", kSmallestHandCm, kLargestHandCm);
  }
  return ready(given) ? std::optional(given) : std::nullopt;
}

std::optional<Checklist> ticked_again(Checklist known) {
  known.headphones = false;
  known.hand_on_top = false;
  return ready(known) ? std::optional(known) : std::nullopt;
}

}  // namespace hedgehog::study
