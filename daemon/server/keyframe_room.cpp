// SPDX-License-Identifier: MIT
#include "daemon/server/keyframe_room.h"

#include <algorithm>

namespace hedgehog::server {
namespace {

using control::LoadKeyframes;

bool same(const model::Keyframe& a, const model::Keyframe& b) noexcept {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.level == b.level && a.t_ms == b.t_ms &&
         a.ease == b.ease;
}

}  // namespace

std::vector<KeyframeRoom::Part>::const_iterator KeyframeRoom::find(
    const KeyframeScore& score) const noexcept {
  return std::find_if(parts_.begin(), parts_.end(), [&](const Part& part) {
    return std::equal(part.frames.begin(), part.frames.end(), score.frames.begin(),
                      score.frames.end(), same);
  });
}

std::size_t KeyframeRoom::commands_for(const KeyframeScore& score) const noexcept {
  return find(score) != parts_.end()
             ? 0
             : (score.frames.size() + LoadKeyframes::kMost - 1) / LoadKeyframes::kMost;
}

bool KeyframeRoom::within_share(const KeyframeScore& score, ConnectionId owner) const noexcept {
  if (find(score) != parts_.end()) {
    return true;
  }
  std::size_t held = score.frames.size();
  for (const Part& part : parts_) {
    held += part.owner == owner ? part.frames.size() : 0;
  }
  return held <= kShare;
}

std::optional<std::uint16_t> KeyframeRoom::place(const KeyframeScore& score, ConnectionId owner,
                                                 Outbox& outbox) {
  if (const auto known = find(score); known != parts_.end()) {
    ++parts_[static_cast<std::size_t>(known - parts_.begin())].users;
    return known->first;
  }
  const std::size_t count = score.frames.size();
  std::size_t first = 0;
  auto before = parts_.begin();
  while (before != parts_.end() && first + count > before->first) {
    first = before->first + before->frames.size();
    ++before;
  }
  if (first + count > control::kKeyframeRoom) {
    return std::nullopt;
  }
  for (std::size_t sent = 0; sent < count; sent += LoadKeyframes::kMost) {
    LoadKeyframes load;
    load.first = static_cast<std::uint16_t>(first + sent);
    load.count =
        static_cast<std::uint8_t>(std::min<std::size_t>(LoadKeyframes::kMost, count - sent));
    std::copy_n(score.frames.begin() + static_cast<std::ptrdiff_t>(sent), load.count,
                load.frames.begin());
    outbox.add(owner, load);
  }
  parts_.insert(before, {static_cast<std::uint16_t>(first), score.frames, owner, 1});
  return static_cast<std::uint16_t>(first);
}

void KeyframeRoom::let_go(std::uint16_t first) noexcept {
  const auto part =
      std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return p.first == first; });
  if (part != parts_.end() && --part->users == 0) {
    parts_.erase(part);
  }
}

void KeyframeRoom::applied(std::uint64_t seq) noexcept {
  std::erase_if(leaving_, [&](const Leaving& leaving) {
    if (leaving.seq > seq) {
      return false;
    }
    let_go(leaving.first);
    return true;
  });
}

}  // namespace hedgehog::server
