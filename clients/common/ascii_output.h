// SPDX-License-Identifier: MIT
// Output for a terminal without UTF-8.
#pragma once

#include <span>
#include <string>
#include <string_view>

namespace hedgehog::client {

/// `text` with the non-ASCII characters that these programs print replaced by ASCII: "41.2 C", "12
/// deg left", "us". Other characters, of external text, are unchanged.
std::string in_ascii(std::string_view text);

/// From here on, output to stdout and stderr by stdio, std::cout and std::cerr is converted by
/// `in_ascii`. Call it once, before any output.
void print_in_ascii();

/// `print_in_ascii()` where the locale is not UTF-8, unless the program's `arguments` request JSON
/// or CSV: these are UTF-8 in every locale.
void print_as_the_locale_allows(std::span<const std::string> arguments);

}  // namespace hedgehog::client
