// SPDX-License-Identifier: MIT
// A text as typed on a command line.
#pragma once

#include <string>

#include "clients/lib/client_error.h"

namespace hedgehog::client {

/// `text` as a JSON string; kBadAddress if it is not UTF-8, which the protocol requires. `name`: of
/// the parameter, for the message.
Outcome<std::string> text_json(const std::string& name, const std::string& text);

}  // namespace hedgehog::client
