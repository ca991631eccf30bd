// SPDX-License-Identifier: MIT
// Files that are whole or not there, whenever the program is killed. May wait for the disk.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

namespace hedgehog::base {

/// Writes beside `path`, syncs, renames: afterwards there is the old content or the new one. An
/// empty string, or what went wrong. `mode`: of a file that is new.
std::string write_file_atomically(const std::string& path, std::string_view content,
                                  mode_t mode = 0640);
/// Afterwards what was made, renamed or removed in `folder` is so on disk; empty: the one that the
/// program is in. An empty string, or what went wrong.
std::string sync_folder(const std::string& folder);

}  // namespace hedgehog::base
