// SPDX-License-Identifier: MIT
#include "clients/study/verbs/checklist.h"

#include <cstdio>
#include <iostream>

#include "clients/study/verbs/checklist_answers.h"

namespace hedgehog::study {

namespace {

/// Repeats the question until confirmed; q gives up.
bool ticked(bool& given, const std::string& question, const Prompt& ask) {
  std::string prompt = question + " [y/n]";
  while (!given) {
    const auto answer = ask(prompt);
    if (!answer || *answer == "q") return false;
    const auto ready = parse_yes_no(*answer);
    given = ready.value_or(false);
    prompt = (ready ? "y when it is, q gives up: " : "y or n, please: ") + question + " [y/n]";
  }
  return true;
}

/// Repeats the question until there is a response, if one is `needed`.
bool filled(std::string& given, const std::string& question, bool needed, const Prompt& ask) {
  while (given.empty()) {
    const auto answer = ask(question);
    if (!answer) return false;
    given = *answer;
    if (!needed) break;
  }
  return true;
}

/// Repeats the question until `parse` accepts the response.
template <class T>
std::optional<T> parsed(Result<T> (*parse)(std::string_view), const std::string& question,
                        const Prompt& ask) {
  std::string prompt = question;
  while (true) {
    const auto answer = ask(prompt);
    if (!answer) return std::nullopt;
    auto value = parse(*answer);
    if (value) return *std::move(value);
    prompt = value.error().message + "\n" + question;
  }
}

Result<std::string> parse_hand(std::string_view text) {
  if (text == "left" || text == "right") return std::string(text);
  return Problem{EX_USAGE, "left or right, please"};
}

bool ready(Checklist& given, const Prompt& ask) {
  return ticked(given.headphones, "noise-cancelling headphones on and running?", ask) &&
         ticked(given.hand_on_top, "dominant hand on top of the ball, relaxed?", ask);
}

}  // namespace

std::optional<std::string> prompt_terminal(const std::string& question) {
  std::printf("%s ", question.c_str());
  std::fflush(stdout);
  std::string answer;
  if (!std::getline(std::cin, answer)) return std::nullopt;
  return answer;
}

std::optional<Checklist> complete(Checklist given, const Prompt& ask) {
  if (!filled(given.experimenter, "experimenter (a code, not a name):", true, ask) ||
      !filled(given.consent, "consent sheet, its reference:", true, ask))
    return std::nullopt;
  if (given.age_band.empty()) {
    const auto band = parsed(parse_age_band, "age band (22-29; Enter: not said):", ask);
    if (!band) return std::nullopt;
    given.age_band = *band;
  }
  if (given.dominant_hand.empty()) {
    const auto hand = parsed(parse_hand, "dominant hand (left, right):", ask);
    if (!hand) return std::nullopt;
    given.dominant_hand = *hand;
  }
  if (!given.hand_size_cm) {
    given.hand_size_cm =
        parsed(parse_hand_size, "hand, tip of the index finger to the wrist, in cm:", ask);
    if (!given.hand_size_cm) return std::nullopt;
  }
  return ready(given, ask) ? std::optional(given) : std::nullopt;
}

std::optional<Checklist> ticked_again(Checklist known, const Prompt& ask) {
  known.headphones = false;
  known.hand_on_top = false;
  return ready(known, ask) ? std::optional(known) : std::nullopt;
}

std::optional<bool> confirm(const std::string& question, const Prompt& ask) {
  std::string prompt = question + " [y/n]";
  while (true) {
    const auto answer = ask(prompt);
    if (!answer) return std::nullopt;
    if (const auto confirmed = parse_yes_no(*answer)) return confirmed;
    prompt = "y or n, please: " + question + " [y/n]";
  }
}

}  // namespace hedgehog::study
