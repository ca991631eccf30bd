// SPDX-License-Identifier: MIT
#include "daemon/server/device/outbox.h"

#include <algorithm>
#include <utility>

#include "daemon/device/tick_clock.h"

namespace hedgehog::server {

bool Outbox::has_capacity(ConnectionId owner, std::size_t count) const {
  const auto each = waiting_each_.find(owner);
  const std::size_t own = each == waiting_each_.end() ? 0 : each->second;
  const bool shared_capacity = waiting_ + count <= kMaxWaiting && own + count <= kMaxWaitingEach;
  return !exceeds_group(count) && (shared_capacity || own + count <= kAlwaysEach);
}

std::optional<std::uint64_t> Outbox::add(ConnectionId owner, const What& what,
                                         std::uint64_t after) {
  if (!has_capacity(owner, 1)) return std::nullopt;
  ++waiting_each_[owner];
  ++waiting_;
  open_.push_back({owner, {++last_seq_, what}, after});
  mailbox_.request_times.received(last_seq_,
                                  received_ns_ != 0 ? received_ns_ : device::monotonic_ns());
  return last_seq_;
}

bool Outbox::amend(control::EffectId effect, const model::EffectSpec& spec) noexcept {
  bool waits = false;
  const auto amend_in = [&](std::vector<Owned>& group) {
    for (Owned& owned : group) {
      auto* start = std::get_if<control::StartEffect>(&owned.command.what);
      // Different key frames may be queued after the start.
      if (start != nullptr && start->effect == effect &&
          start->spec.trajectory.playback.same_frames(spec.trajectory.playback)) {
        start->spec = spec;
        waits = true;
      }
      auto* update = std::get_if<control::UpdateEffect>(&owned.command.what);
      // An update follows the start.
      if (waits && update != nullptr && update->effect == effect) update->spec = spec;
    }
  };
  for (std::vector<Owned>& group : groups_) amend_in(group);
  amend_in(open_);
  return waits;
}

bool Outbox::is_due(const std::vector<Owned>& group) const noexcept {
  // Earlier commands of the same group are applied with it.
  return std::all_of(group.begin(), group.end(), [&](const Owned& owned) {
    return owned.after <= applied_seq_ || owned.after >= group.front().command.seq;
  });
}

void Outbox::commit() {
  if (!open_.empty()) groups_.push_back(std::exchange(open_, {}));
  flush();
}

void Outbox::flush() {
  if (groups_.empty()) return;
  const std::size_t queued = control::Mailbox::kCommands - mailbox_.commands.write_available();
  ready_.clear();
  const std::int64_t now_ns = device::monotonic_ns();
  while (!groups_.empty() && is_due(groups_.front()) &&
         queued + ready_.size() + groups_.front().size() <= control::kMaxCommandsPerTick) {
    for (const Owned& owned : groups_.front()) {
      ready_.push_back(owned.command);
      mailbox_.request_times.queued(owned.command.seq, now_ns);
      handed_over_seq_ = owned.command.seq;
      const auto each = waiting_each_.find(owned.owner);
      if (--each->second == 0) waiting_each_.erase(each);
    }
    groups_.pop_front();
  }
  waiting_ -= ready_.size();
  // One push: the control thread receives all of it or nothing.
  mailbox_.commands.push(ready_.data(), ready_.size());
}

}  // namespace hedgehog::server
