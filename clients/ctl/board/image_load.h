// SPDX-License-Identifier: MIT
// The way of an image into a board that is in its boot loader: a mounted volume, or picotool,
// whichever is there first.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "clients/common/problem.h"
#include "clients/ctl/board/boot_volume.h"

namespace hedgehog::client {

struct ImageLoad {
  /// A checked UF2 file, and what it has.
  std::string file{};
  std::string content{};
  /// Where the volume is or will be mounted; empty: wherever one is, or picotool.
  std::string volume{};
  /// 0: what is there now.
  std::chrono::milliseconds patience{0};
  /// The volumes of now; tests have their own.
  std::function<std::vector<std::string>()> volumes = mounted_boot_volumes;
};

/// By which way it got there.
struct LoadedBy {
  /// Empty: by picotool.
  std::string volume{};
};

/// Returns when the boot loader has all of it. Problems: 69 nothing took it in time, 73 the volume
/// did not, 130 interrupted.
Result<LoadedBy> load_image(const ImageLoad& load);

}  // namespace hedgehog::client
