// SPDX-License-Identifier: MIT
// Output for a terminal that knows no UTF-8.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hedgehog::client {

/// `text` with the characters that these programs print beyond ASCII written in ASCII: "41.2 C",
/// "12 deg left", "us". Characters that came from outside stay.
std::string in_ascii(std::string_view text);

/// What is printed to stdout and stderr, by stdio, std::cout and std::cerr, goes through `in_ascii`
/// from here on. Call it once, before anything is printed.
void print_in_ascii();

/// `print_in_ascii()` where the locale is not UTF-8, unless `arguments`, those of the program, ask
/// for JSON or CSV: these are UTF-8 in every locale.
void print_as_the_locale_allows(std::span<const std::string> arguments);

}  // namespace hedgehog::client
