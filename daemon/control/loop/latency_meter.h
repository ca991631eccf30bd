// SPDX-License-Identifier: MIT
// Latency of effects from the tick that applied them to the frame that carries their set-point.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

#include "daemon/control/effects/effect_times.h"
#include "daemon/control/mailbox.h"
#include "daemon/control/step_inputs.h"
#include "daemon/device/link_port.h"

namespace hedgehog::control {

/// Control thread. Real-time safe. Measures only: control does not depend on it.
class LatencyMeter {
 public:
  /// The commands of `inputs` were applied, in the set-point with the count `set_point`.
  void applied(const StepInputs& inputs, const RequestTimes& requests, std::uint64_t set_point,
               std::int64_t now_ns) noexcept {
    for (std::uint16_t i = 0; i < inputs.command_count; ++i) {
      const Command& command = inputs.commands[i];
      const bool of_effect = std::holds_alternative<StartEffect>(command.what) ||
                             std::holds_alternative<UpdateEffect>(command.what);
      const EffectTimes asked = requests.of(command.seq);
      if (!of_effect || asked.received_ns == 0 || size_ == pending_.size()) continue;
      Pending& pending = pending_[(first_ + size_++) % pending_.size()];
      pending = {set_point, asked};
      pending.times.applied_ns = now_ns;
    }
  }

  /// Sends the times of the set-points written by the link to io; discards all without a board.
  void written(const device::LinkReport& report, Mailbox& mailbox) noexcept {
    if (!report.present) size_ = 0;
    while (size_ > 0 && pending_[first_].set_point <= report.written_count) {
      EffectTimes& times = pending_[first_].times;
      times.written_ns = report.written_ns;
      mailbox.effect_times.push(times);
      first_ = (first_ + 1) % pending_.size();
      --size_;
    }
  }

 private:
  struct Pending {
    std::uint64_t set_point = 0;
    EffectTimes times;
  };
  /// Exceeds the number of commands in the few ticks of link latency; further ones are not
  /// measured.
  static constexpr std::size_t kPending = 256;

  std::array<Pending, kPending> pending_{};
  std::size_t first_ = 0;
  std::size_t size_ = 0;
};

}  // namespace hedgehog::control
