// SPDX-License-Identifier: MIT
// `hedgehogctl devices`: connected devices, the use of each, and why others are not used; 80
// columns on a terminal, one line each in a pipe.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/screen/status_screen.h"
#include "protocol/methods.h"

namespace hedgehog::client {

/// `ball`: its name. The result is never empty.
std::vector<std::string> devices_screen(const protocol::DevicesResult& seen,
                                        const std::string& ball, const ScreenStyle& style = {});

}  // namespace hedgehog::client
