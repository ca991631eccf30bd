// SPDX-License-Identifier: MIT
// `hedgehogctl devices`: what is connected, what each is used for, and why not; on a
// terminal in 80 columns, into a pipe a line each.
#pragma once

#include <string>
#include <vector>

#include "clients/ctl/screen/status_screen.h"
#include "protocol/methods.h"

namespace hedgehog::client {

/// `ball`: its name. Never empty.
std::vector<std::string> devices_screen(const protocol::DevicesResult& seen,
                                        const std::string& ball, const ScreenStyle& style = {});

}  // namespace hedgehog::client
