// SPDX-License-Identifier: MIT
// Lines of CSV (RFC 4180).
#pragma once

#include <string>
#include <vector>

namespace hedgehog::client {

/// Without its end; a cell with a comma, a quote or the end of a line in it is quoted.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace hedgehog::client
