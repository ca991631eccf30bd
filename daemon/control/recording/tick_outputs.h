// SPDX-License-Identifier: MIT
// Outputs of one tick that a replay compares.
#pragma once

#include <bit>
#include <cstdint>
#include <type_traits>

#include "daemon/control/controller.h"
#include "daemon/control/state/event_list.h"
#include "daemon/control/state/state.h"
#include "daemon/device/board_io.h"
#include "model/vec3.h"

namespace hedgehog::control {

struct TickOutputs {
  device::BoardCommand board;
  State state = State::kAbsent;
  Reason reason = Reason::kNone;
  std::uint16_t events = 0;
  model::Vec3 passed_a;
  double hottest_c = 0.0;
};

static_assert(std::is_trivially_copyable_v<TickOutputs>);

/// Real-time safe.
inline TickOutputs outputs_of(const Controller& controller, const device::BoardCommand& board,
                              const EventList& events) noexcept {
  return {board,
          controller.state(),
          controller.reason(),
          static_cast<std::uint16_t>(events.size()),
          controller.passed().a(),
          controller.thermal().hottest_c};
}

/// Bitwise equality: -0 is not 0, and a NaN equals itself.
inline bool same_bits(const TickOutputs& a, const TickOutputs& b) noexcept {
  const auto same = [](double x, double y) noexcept {
    return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
  };
  return a.board.enable() == b.board.enable() && a.board.duty_q15() == b.board.duty_q15() &&
         a.board.boost_q15() == b.board.boost_q15() && a.board.fan == b.board.fan &&
         a.board.arm_count == b.board.arm_count &&
         a.board.boot_loader_count == b.board.boot_loader_count && a.state == b.state &&
         a.reason == b.reason && a.events == b.events && same(a.passed_a.x, b.passed_a.x) &&
         same(a.passed_a.y, b.passed_a.y) && same(a.passed_a.z, b.passed_a.z) &&
         same(a.hottest_c, b.hottest_c);
}

}  // namespace hedgehog::control
