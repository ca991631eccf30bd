// SPDX-License-Identifier: MIT
// The files of tokens and of TLS.
#pragma once

#include <functional>
#include <string>

#include "base/regular_file.h"
#include "daemon/config/config.h"
#include "daemon/config/config_error.h"
#include "daemon/config/keys/key_tree.h"

namespace hedgehog::config {

/// Settles the places of the files, and reads them: the tokens always, certificate and key where
/// an address has TLS. Such an address is an error as long as a file is missing: nobody could be
/// kept out. A file of no tokens keeps everybody out, and is none. REQUIRES: `state_directory` is
/// settled.
void settle_access(Config& config, const Origins& origins, const std::string& config_file,
                   const std::function<base::FileText(const std::string&)>& reader,
                   ConfigErrors& errors);

}  // namespace hedgehog::config
