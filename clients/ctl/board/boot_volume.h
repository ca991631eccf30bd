// SPDX-License-Identifier: MIT
// The mass storage of an RP2040 in its boot loader: a small FAT file system, which programs a UF2
// file that is copied to it and then disconnects.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::client {

/// True if the folder contains the INFO_UF2.TXT of an RP2040's boot loader.
bool is_boot_volume(const std::string& folder);

/// The boot volumes among the mount points in `mounts`, which is in the format of
/// /proc/self/mounts. Only FAT file systems are opened: others may hang.
std::vector<std::string> boot_volumes(std::string_view mounts);
/// The boot volumes of this machine.
std::vector<std::string> mounted_boot_volumes();

/// Copies `content` to the volume and waits until the device has received it. Returns the error, or
/// empty. The device restarts after the last block, so errors after that are not failures.
std::string copy_to_volume(const std::string& volume, std::string_view content);

}  // namespace hedgehog::client
