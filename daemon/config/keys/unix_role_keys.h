// SPDX-License-Identifier: MIT
// The keys "access.unix" of hedgehogd.json, documented there.
#pragma once

#include <string>
#include <vector>

#include "base/keys/file_error.h"
#include "base/keys/key_tree.h"
#include "daemon/config/keys/config_keys.h"

namespace hedgehog::config {

void add_unix_role_keys(std::vector<keys::Key<Draft>>& keys);

/// Adds to `errors` the lists without effect because everybody has a higher role: such a
/// configuration appears restricted, but is not.
void check_unix_roles(const access::UnixRoles& roles, const keys::Origins& origins,
                      const std::string& file, keys::FileErrors& errors);

}  // namespace hedgehog::config
