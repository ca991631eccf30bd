// SPDX-License-Identifier: MIT
// Token and TLS files.
#pragma once

#include <functional>
#include <string>

#include "base/keys/file_error.h"
#include "base/keys/key_tree.h"
#include "base/regular_file.h"
#include "daemon/config/config.h"

namespace hedgehog::config {

/// Resolves the paths of the files and reads them: tokens always, certificate and key if an address
/// has TLS. With TLS a missing file is an error: access could not be restricted. An empty token
/// file rejects every client and is no error. REQUIRES: `state_directory` is resolved.
void resolve_access(Config& config, const keys::Origins& origins, const std::string& config_file,
                    const std::function<base::FileText(const std::string&)>& reader,
                    keys::FileErrors& errors);

}  // namespace hedgehog::config
