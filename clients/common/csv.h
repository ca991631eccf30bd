// SPDX-License-Identifier: MIT
// Lines of CSV (RFC 4180).
#pragma once

#include <string>
#include <vector>

namespace hedgehog::client {

/// Without a line end; cells with a comma, a quote or a line end are quoted.
std::string csv_line(const std::vector<std::string>& cells);

}  // namespace hedgehog::client
