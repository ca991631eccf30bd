// SPDX-License-Identifier: MIT
// What a game has sent to the gamepad device, as text for people.
#pragma once

#include <string>

#include "clients/gamepad/gamepad_device.h"

namespace hedgehog::gamepad {

/// One line with the values of Linux' `ff_effect`: "upload 0: sine from 0x4000, 10 ms, magnitude
/// 16384, length 20000 ms", "play 0, 1 time", "gain 49151", "erase 0".
std::string to_text(const DeviceCommand& command);

}  // namespace hedgehog::gamepad
