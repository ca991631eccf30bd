// SPDX-License-Identifier: MIT
// The experimenter's check list before a run.
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "clients/study/journal/event.h"

namespace hedgehog::study {

/// Asks a question and returns the line of the response; nullopt at the end of the input.
using Prompt = std::function<std::optional<std::string>(const std::string& question)>;
/// Uses stdout and stdin.
std::optional<std::string> prompt_terminal(const std::string& question);

/// Asks for whatever is missing in `given`. Invalid responses are asked for again, valid ones are
/// kept. nullopt: the experimenter gave up, or end of input.
std::optional<Checklist> complete(Checklist given, const Prompt& ask = prompt_terminal);
/// Asks for what may have changed since, headphones and hand; the rest is kept. nullopt as above.
std::optional<Checklist> ticked_again(Checklist known, const Prompt& ask = prompt_terminal);
/// A yes/no question, repeated until the response is valid. nullopt at the end of the input.
std::optional<bool> confirm(const std::string& question, const Prompt& ask = prompt_terminal);

}  // namespace hedgehog::study
