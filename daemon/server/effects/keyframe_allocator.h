// SPDX-License-Identifier: MIT
// Allocation of the control thread's key frames to effects.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "daemon/control/effects/command.h"
#include "daemon/server/device/outbox.h"
#include "daemon/server/effects/keyframe_track.h"

namespace hedgehog::server {

/// io thread only. Equal key frames that are there already are used again, so that a pattern which
/// is sent every frame travels once. A part is free when its last user has let go.
class KeyframeAllocator {
 public:
  /// The part that begins at `first` is that of `track`.
  bool holds(std::uint16_t first, const KeyframeTrack& track) const noexcept;
  /// Commands that `place` would add for `track`, besides that which starts the effect.
  std::size_t commands_for(const KeyframeTrack& track) const noexcept;
  /// One connection may fill half of it at most.
  static constexpr int kShare = control::kKeyframeCapacity / 2;
  bool within_share(const KeyframeTrack& track, ConnectionId owner) const noexcept;
  /// The first of its key frames in the room; what is not there yet is added to `outbox`, which
  /// must have room for it. nullopt: the room is full. One user more.
  std::optional<std::uint16_t> place(const KeyframeTrack& track, ConnectionId owner,
                                     Outbox& outbox);
  /// One user less of what begins there: its `effect_ended` was taken.
  void release(std::uint16_t first) noexcept;
  /// The same, once the control thread has applied `seq`: an update put other key frames there.
  void release_after(std::uint16_t first, std::uint64_t seq) { closing_.push_back({first, seq}); }
  void applied(std::uint64_t seq) noexcept;

 private:
  struct Part {
    std::uint16_t first = 0;
    std::vector<model::Keyframe> frames;
    ConnectionId owner = 0;  // who brought it
    int users = 0;
  };
  struct Releasing {
    std::uint16_t first = 0;
    std::uint64_t seq = 0;
  };
  std::vector<Part>::const_iterator find(const KeyframeTrack& track) const noexcept;

  std::vector<Part> parts_;  // by `first`
  std::vector<Releasing> closing_;
};

}  // namespace hedgehog::server
