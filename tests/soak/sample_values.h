// SPDX-License-Identifier: MIT
// Texts and values for requests where a schema leaves them open.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::soak {

/// Valid and invalid values for the string parameter `name`. Empty: any text.
const std::vector<std::string>& sample_texts(std::string_view name);
/// Quaternions as JSON, one of them not of unit length.
const std::vector<std::string>& sample_quaternions();
/// JSON values that most parameters reject; some are invalid JSON, or too large for a double.
const std::vector<std::string>& unusual_values();
/// JSON values that are no requests.
const std::vector<std::string>& no_requests();

}  // namespace hedgehog::soak
