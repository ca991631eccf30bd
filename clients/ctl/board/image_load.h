// SPDX-License-Identifier: MIT
// Loading of an image into a board in its boot loader: by a mounted volume or by picotool,
// whichever is available first.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/ctl/board/boot_volume.h"

namespace hedgehog::client {

struct ImageLoad {
  /// A checked UF2 file, and its content.
  std::string file{};
  std::string content{};
  /// Mount point of the volume, now or later; empty: any boot volume, or picotool.
  std::string volume{};
  /// Timeout; 0: only what is available now.
  std::chrono::milliseconds timeout{0};
  /// The boot volumes mounted now; replaced in tests.
  std::function<std::vector<std::string>()> volumes = mounted_boot_volumes;
};

/// How the image was loaded.
struct LoadedBy {
  /// The volume; empty: by picotool.
  std::string volume{};
};

/// Returns when the boot loader has received all of it. Problems: 69 no boot loader in time, 73
/// writing to the volume failed, 130 interrupted.
Result<LoadedBy> load_image(const ImageLoad& load);

}  // namespace hedgehog::client
