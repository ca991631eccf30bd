// SPDX-License-Identifier: MIT
// Which part of the control thread's room for key frames holds whose.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "daemon/control/command.h"
#include "daemon/server/outbox.h"
#include "daemon/server/score.h"

namespace hedgehog::server {

/// io thread only. Equal key frames that are there already are used again, so that a pattern which
/// is sent every frame travels once. A part is free when its last user has let go.
class KeyframeRoom {
 public:
  /// Commands that `place` would add for `score`, besides that which starts the effect.
  std::size_t commands_for(const KeyframeScore& score) const noexcept;
  /// At most half the room may be filled by one connection, so that others find some.
  static constexpr int kShare = control::kKeyframeRoom / 2;
  bool within_share(const KeyframeScore& score, ConnectionId owner) const noexcept;
  /// The first of its key frames in the room; what is not there yet is added to `outbox`, which
  /// must have room for it. nullopt: the room is full. One user more.
  std::optional<std::uint16_t> place(const KeyframeScore& score, ConnectionId owner,
                                     Outbox& outbox);
  /// One user less of what begins there: its `effect_ended` was taken.
  void let_go(std::uint16_t first) noexcept;
  /// The same, once the control thread has applied `seq`: an update put other key frames there.
  void let_go_after(std::uint16_t first, std::uint64_t seq) { leaving_.push_back({first, seq}); }
  void applied(std::uint64_t seq) noexcept;

 private:
  struct Part {
    std::uint16_t first = 0;
    std::vector<model::Keyframe> frames;
    ConnectionId owner = 0;  // who brought it
    int users = 0;
  };
  struct Leaving {
    std::uint16_t first = 0;
    std::uint64_t seq = 0;
  };
  std::vector<Part>::const_iterator find(const KeyframeScore& score) const noexcept;

  std::vector<Part> parts_;  // by `first`
  std::vector<Leaving> leaving_;
};

}  // namespace hedgehog::server
