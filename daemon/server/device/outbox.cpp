// SPDX-License-Identifier: MIT
#include "daemon/server/device/outbox.h"

#include <array>
#include <utility>

#include "daemon/device/tick_clock.h"

namespace hedgehog::server {

bool Outbox::has_capacity(ConnectionId owner, std::size_t count) const {
  const auto each = waiting_each_.find(owner);
  const std::size_t own = each == waiting_each_.end() ? 0 : each->second;
  const bool room_for_all = waiting_ + count <= kMaxWaiting && own + count <= kMaxWaitingEach;
  return !exceeds_group(count) && (room_for_all || own + count <= kAlwaysEach);
}

std::optional<std::uint64_t> Outbox::add(ConnectionId owner, const What& what) {
  if (!has_capacity(owner, 1)) return std::nullopt;
  ++waiting_each_[owner];
  ++waiting_;
  open_.push_back({owner, {++last_seq_, what}});
  mailbox_.request_times.asked(last_seq_, device::monotonic_ns());
  return last_seq_;
}

void Outbox::commit() {
  if (!open_.empty()) groups_.push_back(std::exchange(open_, {}));
  flush();
}

void Outbox::flush() {
  if (groups_.empty()) return;
  const std::size_t queued = control::Mailbox::kCommands - mailbox_.commands.write_available();
  std::array<control::Command, control::kMaxCommandsPerTick> ready{};
  std::size_t count = 0;
  while (!groups_.empty() && queued + count + groups_.front().size() <= ready.size()) {
    for (const Owned& owned : groups_.front()) {
      ready[count++] = owned.command;
      const auto each = waiting_each_.find(owned.owner);
      if (--each->second == 0) waiting_each_.erase(each);
    }
    groups_.pop_front();
  }
  waiting_ -= count;
  // One push: the control thread sees all of it or nothing.
  mailbox_.commands.push(ready.data(), count);
}

}  // namespace hedgehog::server
