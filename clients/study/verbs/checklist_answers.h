// SPDX-License-Identifier: MIT
// Validation of the check list's responses, on the command line and at the prompt.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "clients/common/problem.h"

namespace hedgehog::study {

/// "18.3": 10 to 30 cm, with a decimal point and nothing after the number. EX_USAGE with a
/// sentence.
Result<double> parse_hand_size(std::string_view text);
/// "22-29", or "70+": integer years, at most 120, the first below the second. EX_USAGE with a
/// sentence. Empty stays empty: not given.
Result<std::string> parse_age_band(std::string_view text);
/// "y", "yes", "n", "no", in either case; nullopt for anything else.
std::optional<bool> parse_yes_no(std::string_view text);

}  // namespace hedgehog::study
