// SPDX-License-Identifier: MIT
// `hedgehogctl devices`: what is connected, what each is used for, and why not, in 80 columns.
#pragma once

#include <string>
#include <vector>

#include "protocol/methods.h"

namespace hedgehog::client {

/// `ball`: its name. Never empty.
std::vector<std::string> devices_screen(const protocol::DevicesResult& seen,
                                        const std::string& ball);

}  // namespace hedgehog::client
