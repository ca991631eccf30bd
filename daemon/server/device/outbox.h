// SPDX-License-Identifier: MIT
// The io side of the command queue. The commands of one line are one group, and a group is handed
// over as a whole in time for a single tick (a batch is "applied in one tick"). Bounded in total
// and for each client, so that a flooding client is answered `busy` while the others are served.
// The start of an effect that replaces another waits here until that one's start was applied, and
// can be amended as long as it waits: however often a slot is filled, once a tick is enough.
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
  /// Reserved for each client, however many others flood.
  static constexpr std::size_t kAlwaysEach = 8;

  explicit Outbox(control::Mailbox& mailbox) : mailbox_(mailbox) {}

  /// True if the open group takes `count` more commands of `owner`.
  bool has_capacity(ConnectionId owner, std::size_t count) const;
  /// True if `count` more are too many for one group, whenever they are sent.
  bool exceeds_group(std::size_t count) const noexcept {
    return open_.size() + count > control::kMaxCommandsPerTick;
  }
  /// Adds a command of `owner` to the open group and returns its seq; nullopt: full, `busy`. It is
  /// handed over once `after` has been applied; what was added later waits with it.
  std::optional<std::uint64_t> add(ConnectionId owner, const What& what, std::uint64_t after = 0);
  /// The command with that seq was not handed over yet.
  bool holds(std::uint64_t seq) const noexcept { return seq > handed_over_seq_; }
  /// Gives the start of `effect`, and all updates of it, the spec `spec`. False, and nothing is
  /// changed: that start has been handed over.
  bool amend(control::EffectId effect, const model::EffectSpec& spec) noexcept;
  /// When the request was read that commands are added for, CLOCK_MONOTONIC; 0: it is none, or as
  /// they are added.
  void set_received(std::int64_t ns) noexcept { received_ns_ = ns; }
  /// Closes the group and hands over what fits.
  void commit();
  /// Hands over what fits; call it at least every millisecond while `waiting()`.
  void flush();
  /// The control thread has applied everything up to `seq`.
  void set_applied(std::uint64_t seq) noexcept { applied_seq_ = seq; }

  bool waiting() const noexcept { return !groups_.empty(); }
  /// Seq of the newest command.
  std::uint64_t last_seq() const noexcept { return last_seq_; }

 private:
  struct Owned {
    ConnectionId owner;
    control::Command command;
    std::uint64_t after;
  };
  /// Nothing in `group` has to wait for what was not applied yet.
  bool is_due(const std::vector<Owned>& group) const noexcept;
  control::Mailbox& mailbox_;
  std::deque<std::vector<Owned>> groups_;
  std::vector<Owned> open_;
  /// Being handed over; kept for its memory.
  std::vector<control::Command> ready_;
  std::size_t waiting_ = 0;
  std::map<ConnectionId, std::size_t> waiting_each_;
  std::int64_t received_ns_ = 0;
  std::uint64_t last_seq_ = 0;
  std::uint64_t handed_over_seq_ = 0;
  std::uint64_t applied_seq_ = 0;
};

}  // namespace hedgehog::server
