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

/// io thread only. Equal key frames that are already loaded are reused, so that a pattern which is
/// sent every frame is transferred once. A range is free when its last user has released it.
class KeyframeAllocator {
 public:
  /// The range that starts at `first` contains `track`.
  bool holds(std::uint16_t first, const KeyframeTrack& track) const noexcept;
  /// Number of commands that `place` would add for `track`, besides that which starts the effect.
  std::size_t commands_for(const KeyframeTrack& track) const noexcept;
  static constexpr int kShare = control::kKeyframeCapacity / 2;  // of one connection
  bool within_share(const KeyframeTrack& track, ConnectionId owner) const noexcept;
  /// Returns the first slot of its key frames, with one more user; nullopt: no free range. Those
  /// not loaded yet are added to `outbox`, which must have capacity for them.
  std::optional<std::uint16_t> place(const KeyframeTrack& track, ConnectionId owner,
                                     Outbox& outbox);
  /// Removes one user of the range at `first`: its `effect_ended` was read.
  void release(std::uint16_t first) noexcept;
  /// The same, once the control thread has applied `seq`, an update to other key frames.
  void release_after(std::uint16_t first, std::uint64_t seq) { closing_.push_back({first, seq}); }
  void applied(std::uint64_t seq) noexcept;

 private:
  struct Part {
    std::uint16_t first = 0;
    std::vector<model::Keyframe> frames;
    ConnectionId owner = 0;  // the connection that loaded it
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
