// SPDX-License-Identifier: MIT
// The programs under test: paths in the build folder given by the environment variable
// HEDGEHOG_PROGRAMS, which must contain a daemon; programs missing there are this build's.
#pragma once

#include <string>
#include <vector>

namespace hedgehog::e2e {

std::string hedgehogd();
std::string hedgehogctl();
std::string hedgehog_design();
std::string hedgehog_gamepad();
std::string hedgehog_mqtt();
std::string hedgehog_orientation();
std::string hedgehog_racer();
std::string hedgehog_study();
std::string hedgehog_usbip();

/// The paths of all programs that cmake/install.cmake installs.
std::vector<std::string> installed_programs();

/// A --speed that these programs can sustain: `wanted`, or the environment's HEDGEHOG_SPEED_LIMIT.
int attainable_speed(int wanted);

}  // namespace hedgehog::e2e
