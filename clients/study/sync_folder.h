// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace hedgehog::study {

/// Flushes the entries of a directory to the disk (fsync), so that a file created or renamed in it
/// is there after a power cut. Blocking; an error is ignored, the file itself has been flushed.
void sync_folder(const std::filesystem::path& folder);

}  // namespace hedgehog::study
