// SPDX-License-Identifier: MIT
// `hedgehogctl check --json`: the line of the monitoring plug-in as an object. Pure.
#pragma once

#include <string>

#include "clients/ctl/screen/check_screen.h"

namespace hedgehog::client {

/// {"code":1,"state":"WARNING","message":"ball armed, derated","measures":{"temperature":
/// {"value":61.2,"unit":"","warning":60,"critical":70},...}} of "HEDGEHOG WARNING - ball armed,
/// derated | temperature=61.2;60;70 ...", with performance data as defined by the Monitoring
/// Plugins' guidelines.
std::string check_json(const Check& check);

}  // namespace hedgehog::client
