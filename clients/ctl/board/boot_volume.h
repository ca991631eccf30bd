// SPDX-License-Identifier: MIT
// The mass storage of an RP2040 in its boot loader: a small FAT file system, which takes a UF2 file
// that is copied to it, and then is gone.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::client {

/// The folder has the INFO_UF2.TXT of an RP2040's boot loader.
bool is_boot_volume(const std::string& folder);

/// The mount points in `mounts`, which is in the format of /proc/self/mounts, that are one. Only
/// FAT file systems are looked into: others may hang.
std::vector<std::string> boot_volumes(std::string_view mounts);
/// Those of this machine.
std::vector<std::string> mounted_boot_volumes();

/// Copies `content` to the volume and waits until the device has it. Why it did not, or empty. The
/// device restarts when it has the last block, so what goes wrong after that is no failure.
std::string copy_to_volume(const std::string& volume, std::string_view content);

}  // namespace hedgehog::client
