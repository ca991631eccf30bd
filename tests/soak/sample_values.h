// SPDX-License-Identifier: MIT
// Texts and values that requests are made of where a schema leaves them open.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::soak {

/// For the string parameter `name`: some that mean something, some that do not. Empty: any text.
const std::vector<std::string>& sample_texts(std::string_view name);
/// Quaternions as JSON, one of them not of unit length.
const std::vector<std::string>& sample_quaternions();
/// JSON values that most parameters refuse; some are no JSON, or too large for a double.
const std::vector<std::string>& odd_values();
/// JSON that is no request.
const std::vector<std::string>& no_requests();

}  // namespace hedgehog::soak
