// SPDX-License-Identifier: MIT
#include "clients/ctl/board/image_load.h"

#include <poll.h>

#include <optional>
#include <utility>

#include "clients/common/interrupts.h"
#include "clients/ctl/board/picotool.h"

namespace hedgehog::client {

namespace {

constexpr int kPauseMs = 200;
constexpr std::chrono::milliseconds kPicotoolPause{1000};

class Loader {
 public:
  explicit Loader(const ImageLoad& load) : load_(load) {}

  /// nullopt: no boot loader is available.
  std::optional<Result<LoadedBy>> try_once() {
    const std::vector<std::string> volumes = this->volumes();
    if (volumes.size() > 1) {
      return Result<LoadedBy>(Problem{kUnavailable, "two boards are in their boot loaders, " +
                                                        volumes[0] + " and " + volumes[1] +
                                                        ": select the ball's with --volume"});
    }
    if (!volumes.empty()) {
      std::string why = copy_to_volume(volumes[0], load_.content);
      if (!why.empty()) return Result<LoadedBy>(Problem{kCannotCreate, std::move(why)});
      return Result<LoadedBy>(LoadedBy{volumes[0]});
    }
    if (load_.volume.empty() && std::chrono::steady_clock::now() >= next_picotool_)
      return ask_picotool();
    return std::nullopt;
  }

  Problem give_up() const {
    if (!load_.volume.empty()) {
      return {kUnavailable,
              load_.volume + " is not the volume RPI-RP2 of a board in its boot loader"};
    }
    return {kUnavailable,
            "no board in its boot loader was found: no volume RPI-RP2 is mounted (--volume says "
            "where it is), and " +
                (picotool_.kind == PicotoolEnd::Kind::kMissing
                     ? std::string("picotool is not installed")
                     : "picotool failed: " + picotool_.why)};
  }

 private:
  std::vector<std::string> volumes() const {
    if (load_.volume.empty()) return load_.volumes();
    return is_boot_volume(load_.volume) ? std::vector{load_.volume} : std::vector<std::string>();
  }

  /// Fails until the device is connected, and without permission to open it.
  std::optional<Result<LoadedBy>> ask_picotool() {
    picotool_ = load_by_picotool(load_.file);
    next_picotool_ = std::chrono::steady_clock::now() + kPicotoolPause;
    if (picotool_.kind != PicotoolEnd::Kind::kDone) return std::nullopt;
    return Result<LoadedBy>(LoadedBy{});
  }

  const ImageLoad& load_;
  PicotoolEnd picotool_;
  std::chrono::steady_clock::time_point next_picotool_{};
};

}  // namespace

Result<LoadedBy> load_image(const ImageLoad& load) {
  const auto deadline = std::chrono::steady_clock::now() + load.timeout;
  Loader loader(load);
  for (;;) {
    if (auto loaded = loader.try_once()) return *std::move(loaded);
    if (interrupted())
      return Problem{kInterrupted, "interrupted; the board stays in its boot loader"};
    if (std::chrono::steady_clock::now() >= deadline) return loader.give_up();
    ::poll(nullptr, 0, kPauseMs);
  }
}

}  // namespace hedgehog::client
