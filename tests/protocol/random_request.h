// SPDX-License-Identifier: MIT
// Generators of requests that obey every rule of the protocol.
#pragma once

#include <string>
#include <vector>

#include <rapidcheck.h>

#include "protocol/methods.h"

namespace hedgehog::protocol {

Method random_method();
rc::Gen<Request> random_request();

/// The names of the parameters that the decoder accepts for `method`.
std::vector<std::string> parameter_names(Method method);

}  // namespace hedgehog::protocol
