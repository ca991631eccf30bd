// SPDX-License-Identifier: MIT
#include "clients/ctl/arguments/direction_argument.h"

#include <algorithm>
#include <nlohmann/json.hpp>

#include "clients/ctl/arguments/text_argument.h"

namespace hedgehog::client {

Outcome<std::string> direction_json(const std::string& text) {
  using nlohmann::json;
  const json numbers = json::parse("[" + text + "]", nullptr, false);
  if (numbers.is_discarded()) return text_json("direction", text);
  const bool only_numbers =
      std::all_of(numbers.begin(), numbers.end(), [](const json& n) { return n.is_number(); });
  if (only_numbers && numbers.size() == 3) return numbers.dump();
  if (only_numbers && numbers.size() == 2)
    return json{{"azimuth_deg", numbers[0]}, {"elevation_deg", numbers[1]}}.dump();
  if (only_numbers && numbers.size() == 1 && numbers[0].is_number_integer())
    return json{{"pin", numbers[0]}}.dump();
  return ClientError{Failure::kBadAddress,
                     "direction: '" + text +
                         "' is neither a word (left), a pin (34), azimuth,elevation (90,20) nor "
                         "a vector (0,1,0.5)",
                     {}};
}

}  // namespace hedgehog::client
