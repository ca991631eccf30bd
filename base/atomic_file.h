// SPDX-License-Identifier: MIT
// Atomic file replacement: complete or absent, even if the program is killed. May block on the
// disk.
#pragma once

#include <sys/types.h>

#include <string>
#include <string_view>

namespace hedgehog::base {

/// Writes a file beside `path`, syncs and renames it, so that `path` has either the old or the new
/// content. Returns an empty string, or the error. `mode`: of the file.
std::string write_file_atomically(const std::string& path, std::string_view content,
                                  mode_t mode = 0640);
/// Makes entries created, renamed or removed in `folder` durable; empty: the working directory.
/// Returns an empty string, or the error.
std::string sync_folder(const std::string& folder);

}  // namespace hedgehog::base
