// SPDX-License-Identifier: MIT
// Numbers as text, for display and files. Independent of the locale; allocates.
#pragma once

#include <string>

namespace hedgehog::base {

/// "41.2", "nan", "inf": `decimals` digits after the point; zero, also if rounded, has no sign.
std::string fixed(double value, int decimals);
/// "4 310", "-12,480": no decimals, `separator` between groups of three digits.
std::string grouped(double value, char separator = ' ');
/// "0.1", "1e+16": the shortest decimal form that reads back to the same double.
std::string shortest(double value);

}  // namespace hedgehog::base
