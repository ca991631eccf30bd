// SPDX-License-Identifier: MIT
// The keys "access.unix" of hedgehogd.json, documented there.
#pragma once

#include <string>
#include <vector>

#include "daemon/config/config_error.h"
#include "daemon/config/keys/config_keys.h"
#include "daemon/config/keys/key_tree.h"

namespace hedgehog::config {

void add_unix_role_keys(std::vector<Key<Draft>>& keys);

/// Adds to `errors` the lists without effect because everybody has a higher role: such a
/// configuration appears restricted, but is not.
void check_unix_roles(const access::UnixRoles& roles, const Origins& origins,
                      const std::string& file, ConfigErrors& errors);

}  // namespace hedgehog::config
