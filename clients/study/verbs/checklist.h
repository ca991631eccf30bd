// SPDX-License-Identifier: MIT
// What the experimenter ticks off and asks before a run.
#pragma once

#include <optional>

#include "clients/study/journal/event.h"

namespace hedgehog::study {

/// Asks on the terminal for whatever `given` leaves open. Nothing: the experimenter said that
/// something is not ready, or there was no answer.
std::optional<Checklist> complete(Checklist given);
/// Asks what may have changed since, headphones and hand; the rest stays. Nothing as above.
std::optional<Checklist> ticked_again(Checklist known);

}  // namespace hedgehog::study
