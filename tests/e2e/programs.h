// SPDX-License-Identifier: MIT
// The programs under test: paths in the build folder that the environment's HEDGEHOG_PROGRAMS
// names, where that has the program, else in this build's.
#pragma once

#include <string>

namespace hedgehog::e2e {

std::string hedgehogd();
std::string hedgehogctl();
std::string hedgehog_orientation();
std::string hedgehog_racer();
std::string hedgehog_study();
std::string hedgehog_usbip();

/// A --speed, at most `wanted`, that these programs keep up with: a sanitizer's are slower.
int attainable_speed(int wanted);

}  // namespace hedgehog::e2e
