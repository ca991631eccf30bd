// SPDX-License-Identifier: MIT
#include "daemon/server/effects/keyframe_allocator.h"

#include <algorithm>

namespace hedgehog::server {
namespace {

using control::LoadKeyframes;

bool same(const model::Keyframe& a, const model::Keyframe& b) noexcept {
  return a.x == b.x && a.y == b.y && a.z == b.z && a.level == b.level && a.t_ms == b.t_ms &&
         a.ease == b.ease;
}

}  // namespace

std::vector<KeyframeAllocator::Part>::const_iterator KeyframeAllocator::find(
    const KeyframeTrack& track) const noexcept {
  return std::find_if(
      parts_.begin(), parts_.end(),
      [&](const Part& part) {
        return std::equal(part.frames.begin(), part.frames.end(), track.frames.begin(),
                          track.frames.end(), same);
      });
}

bool KeyframeAllocator::holds(std::uint16_t first, const KeyframeTrack& track) const noexcept {
  const auto part = find(track);
  return part != parts_.end() && part->first == first;
}

std::size_t KeyframeAllocator::commands_for(const KeyframeTrack& track) const noexcept {
  return find(track) != parts_.end() ? 0 : LoadKeyframes::commands_for(track.frames.size());
}

bool KeyframeAllocator::within_share(const KeyframeTrack& track,
                                     ConnectionId owner) const noexcept {
  if (find(track) != parts_.end()) return true;
  std::size_t held = track.frames.size();
  for (const Part& part : parts_) held += part.owner == owner ? part.frames.size() : 0;
  return held <= kShare;
}

std::optional<std::uint16_t> KeyframeAllocator::place(const KeyframeTrack& track,
                                                      ConnectionId owner, Outbox& outbox) {
  if (const auto known = find(track); known != parts_.end()) {
    ++parts_[static_cast<std::size_t>(known - parts_.begin())].users;
    return known->first;
  }
  const std::size_t count = track.frames.size();
  std::size_t first = 0;
  auto before = parts_.begin();
  while (before != parts_.end() && first + count > before->first) {
    first = before->first + before->frames.size();
    ++before;
  }
  if (first + count > control::kKeyframeCapacity) return std::nullopt;
  for (std::size_t i = 0; i < LoadKeyframes::commands_for(count); ++i)
    outbox.add(owner, LoadKeyframes::slice(track.frames, first, i));
  parts_.insert(before, {static_cast<std::uint16_t>(first), track.frames, owner, 1});
  return static_cast<std::uint16_t>(first);
}

void KeyframeAllocator::release(std::uint16_t first) noexcept {
  const auto part =
      std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return p.first == first; });
  if (part != parts_.end() && --part->users == 0) parts_.erase(part);
}

void KeyframeAllocator::applied(std::uint64_t seq) noexcept {
  std::erase_if(
      closing_,
      [&](const Releasing& releasing) {
        if (releasing.seq > seq) return false;
        release(releasing.first);
        return true;
      });
}

}  // namespace hedgehog::server
