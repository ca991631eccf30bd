// SPDX-License-Identifier: MIT
// The io side of the command queue. The commands of one line are a group, passed on as a whole for
// a single tick. Bounded in total and per client, so that a flooding client gets `busy` and the
// others are served. The start of an effect that replaces another waits here until the other's
// start was applied, and can be amended until then: a slot starts at most one effect per tick.
#pragma once

#include <cstdint>
#include <deque>
#include <map>
#include <optional>
#include <vector>

#include "daemon/control/effects/command.h"
#include "daemon/control/mailbox.h"
#include "daemon/server/session/session.h"

namespace hedgehog::server {

/// io thread only.
class Outbox {
 public:
  using What = decltype(control::Command::what);
  static constexpr std::size_t kMaxWaiting = 512;
  static constexpr std::size_t kMaxWaitingEach = 128;
  static constexpr std::size_t kAlwaysEach = 8;  // reserved for each client, whatever others queue

  explicit Outbox(control::Mailbox& mailbox) : mailbox_(mailbox) {}

  /// True if the open group has capacity for `count` more commands of `owner`.
  bool has_capacity(ConnectionId owner, std::size_t count) const;
  /// True if the open group with `count` more commands exceeds the maximum of a group.
  bool exceeds_group(std::size_t count) const noexcept {
    return open_.size() + count > control::kMaxCommandsPerTick;
  }
  /// Adds a command of `owner` to the open group and returns its seq; nullopt: full, `busy`. It is
  /// passed on once `after` has been applied; later commands wait with it.
  std::optional<std::uint64_t> add(ConnectionId owner, const What& what, std::uint64_t after = 0);
  /// The command with that seq has not been passed on yet.
  bool holds(std::uint64_t seq) const noexcept { return seq > handed_over_seq_; }
  /// Sets the spec in the start of `effect` and its updates; false: that start has been passed on.
  bool amend(control::EffectId effect, const model::EffectSpec& spec) noexcept;
  /// When the request of the following commands was read, CLOCK_MONOTONIC; 0: when they are added.
  void set_received(std::int64_t ns) noexcept { received_ns_ = ns; }
  /// Closes the group and passes on what fits.
  void commit();
  /// Passes on what fits; call it at least every millisecond while `waiting()`.
  void flush();
  /// The control thread has applied everything up to `seq`.
  void set_applied(std::uint64_t seq) noexcept { applied_seq_ = seq; }

  bool waiting() const noexcept { return !groups_.empty(); }
  std::uint64_t last_seq() const noexcept { return last_seq_; }  // of the newest command

 private:
  struct Owned {
    ConnectionId owner;
    control::Command command;
    std::uint64_t after;
  };
  /// `group` does not depend on a command that has not been applied yet.
  bool is_due(const std::vector<Owned>& group) const noexcept;
  control::Mailbox& mailbox_;
  std::deque<std::vector<Owned>> groups_;
  std::vector<Owned> open_;
  std::vector<control::Command> ready_;  // being passed on; a member to reuse its memory
  std::size_t waiting_ = 0;
  std::map<ConnectionId, std::size_t> waiting_each_;
  std::int64_t received_ns_ = 0;
  std::uint64_t last_seq_ = 0;
  std::uint64_t handed_over_seq_ = 0;
  std::uint64_t applied_seq_ = 0;
};

}  // namespace hedgehog::server
