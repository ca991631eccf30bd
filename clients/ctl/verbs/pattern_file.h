// SPDX-License-Identifier: MIT
// Patterns in files: as the daemon keeps them, and as other formats have them.
#pragma once

#include <string>

#include "clients/lib/client_error.h"
#include "protocol/values/pattern.h"

namespace hedgehog::client {

/// What is meant by it on a command line: a file rather than the name of a pattern. It ends in
/// ".json"; and "acme/x.json", which may be a vendor's pattern too, only where there is that file.
bool is_pattern_file(const std::string& text);

/// The whole file; kNoInput when it cannot be read, or is larger than 4 MiB.
Outcome<std::string> read_text(const std::string& path);
/// kBadData: "<path>: <what is wrong>".
Outcome<protocol::Pattern> read_pattern(const std::string& path);

}  // namespace hedgehog::client
