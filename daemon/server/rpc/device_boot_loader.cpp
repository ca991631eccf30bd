// SPDX-License-Identifier: MIT
// device.enter_boot_loader
#include <string>

#include "daemon/control/state/state_machine.h"
#include "daemon/server/rpc/handlers.h"

namespace hedgehog::server {
namespace {

/// First minor version of the board protocol with the boot loader frame.
constexpr int kBoardMinor = 2;
/// Ticks until control reports a board in its boot loader as absent.
constexpr model::Tick kGoneBy = control::StateMachine::kBootLoaderTimeout;

protocol::RpcError still_armed() {
  return protocol::armed("the boot loader can be entered only while the ball is not armed",
                         "Run: hedgehogctl stop");
}

protocol::RpcError no_boot_loader(const DeviceView& device_view) {
  return protocol::error(
      protocol::ErrorCode::kUnsupported,
      "unsupported: the board speaks " + device_view.board_protocol().value_or("another version") +
          " of the board protocol; entering the boot loader on request requires 1." +
          std::to_string(kBoardMinor) +
          " or later; unplug it and hold BOOTSEL while plugging it in");
}

}  // namespace

Outcome handle(Call& call, const protocol::DeviceEnterBootLoader&) {
  DeviceView& device_view = call.device_view();
  const control::StatusSnapshot& before = device_view.now();
  if (before.state == control::State::kArmed) return Response(still_armed());
  if (before.state == control::State::kAbsent) return Response(*not_playable(device_view));
  if (before.board.protocol_minor < kBoardMinor) return Response(no_boot_loader(device_view));
  const auto seq = device_view.outbox().add(call.session.id, control::EnterBootLoader{});
  if (!seq) return Response(queue_full(device_view.outbox()));
  return Deferred{[seq = *seq, since = model::Tick{-1}](
                      HandlerContext& context, bool give_up) mutable -> std::optional<Response> {
    const control::StatusSnapshot& now = context.device_view.now();
    const bool applied = now.applied_seq >= seq;
    if (applied && now.state == control::State::kAbsent)
      return Response(protocol::StateResult{std::string(control::name(now.state)),
                                            context.device_view.reason_now(),
                                            context.device_view.remedy_now(), seq});
    if (give_up) return Response(control_stuck());
    if (!applied) return std::nullopt;
    // An arming was in progress.
    if (now.state == control::State::kArmed) return Response(still_armed());
    since = since < 0 ? now.tick : since;
    if (now.tick - since <= kGoneBy) return std::nullopt;
    return Response(protocol::busy("the board has not entered its boot loader", 1000));
  }};
}

}  // namespace hedgehog::server
