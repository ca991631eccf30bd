// SPDX-License-Identifier: MIT
// What the experimenter ticks off and asks before a run.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "clients/study/journal/event.h"

namespace hedgehog::study {

/// Puts a question and returns the line that was answered; nothing at the end of the input.
using Ask = std::function<std::optional<std::string>(const std::string& question)>;
/// On stdout and from stdin.
std::optional<std::string> ask_at_terminal(const std::string& question);

/// Asks for whatever `given` leaves open. An answer that cannot be is asked for again, what was
/// answered stays. Nothing: the experimenter gave up, or there is no more input.
std::optional<Checklist> complete(Checklist given, const Ask& ask = ask_at_terminal);
/// Asks what may have changed since, headphones and hand; the rest stays. Nothing as above.
std::optional<Checklist> ticked_again(Checklist known, const Ask& ask = ask_at_terminal);
/// A question to be answered with yes or no, again until it is. Nothing at the end of the input.
std::optional<bool> confirm(const std::string& question, const Ask& ask = ask_at_terminal);

}  // namespace hedgehog::study
