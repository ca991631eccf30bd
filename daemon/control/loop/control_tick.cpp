// SPDX-License-Identifier: MIT
#include "daemon/control/loop/control_tick.h"

#include <algorithm>
#include <cmath>

#include "daemon/device/tick_clock.h"

namespace hedgehog::control {

ControlTick::ControlTick(const ControlSettings& settings, Mailbox& mailbox, device::LinkPort& port,
                         FlightRecorder* recorder, int speed) noexcept
    : mailbox_(mailbox),
      port_(port),
      recorder_(recorder),
      speed_(std::max(speed, 1)),
      controller_(settings) {}

void ControlTick::gather(model::Tick tick, std::uint32_t skipped) noexcept {
  inputs_.tick = tick;
  inputs_.skipped = skipped;
  inputs_.emergency_generation = mailbox_.emergency_generation.load(std::memory_order_acquire);

  const device::LinkReport& report = port_.reports.read();
  inputs_.board_present = report.present;
  inputs_.board_fresh = report.telemetry_count != telemetry_count_;
  telemetry_count_ = report.telemetry_count;
  inputs_.board = report.telemetry;
  snapshot_.link = report.counters;
  latency_.written(report, mailbox_);

  inputs_.orientation = mailbox_.orientation.read();
  inputs_.thermometer = mailbox_.thermometer.read();
  for (model::Tick* stamp : {&inputs_.orientation.stamp, &inputs_.thermometer.stamp})
    *stamp = tick - std::max<model::Tick>(tick - *stamp, 0) / speed_;

  mailbox_.stops.collect(inputs_);
  const auto taken = mailbox_.commands.pop(inputs_.commands.data(), inputs_.commands.size());
  inputs_.command_count = static_cast<std::uint16_t>(taken);
}

void ControlTick::run(model::Tick tick, std::uint32_t skipped,
                      const LoopStatistics& statistics) noexcept {
  gather(tick, skipped);
  if (recorder_ != nullptr) recorder_->before(controller_, inputs_);
  const device::BoardCommand command = controller_.step(inputs_, events_);
  send(command);
  const std::int64_t sent_ns = inputs_.command_count > 0 ? device::monotonic_ns() : 0;
  if (recorder_ != nullptr) recorder_->after(controller_, command, events_);
  const bool unread = publish();
  controller_.fill(snapshot_);
  snapshot_.loop = statistics;
  add_up(skipped, sent_ns);
  mailbox_.status.write(snapshot_);
  if (unread) mailbox_.wake_io.raise();
}

void ControlTick::add_up(std::uint32_t skipped, std::int64_t sent_ns) noexcept {
  Totals& totals = snapshot_.totals;
  const double seconds = (1.0 + skipped) * model::kTickSeconds;
  if (snapshot_.board_present) {
    const model::Vec3& duty = snapshot_.board.duty;
    totals.on_s =
        totals.on_s + seconds * model::Vec3{std::abs(duty.x), std::abs(duty.y), std::abs(duty.z)};
    const model::Vec3 flowing = flowing_a(snapshot_.board);
    const double flowing_a2 = model::dot(flowing, flowing);
    totals.heat_a2s += seconds * flowing_a2;
    add_peak(flowing_a2);
  } else {
    add_peak(0.0);
  }
  totals.derated_s += snapshot_.derating ? seconds : 0.0;
  if (inputs_.command_count == 0) return;
  for (std::uint16_t i = 0; i < inputs_.command_count; ++i) {
    const std::int64_t asked_ns = mailbox_.request_times.of(inputs_.commands[i].seq).received_ns;
    // 0: the command did not come through the outbox.
    if (asked_ns != 0) totals.request_to_coil.add(sent_ns - asked_ns);
  }
  latency_.applied(inputs_, mailbox_.request_times, sent_, sent_ns);
}

void ControlTick::add_peak(double current_a2) noexcept {
  if (++peak_ticks_ > kPeakTicks) {
    peaks_a2_ = {peaks_a2_[1], 0.0};
    peak_ticks_ = 1;
  }
  peaks_a2_[1] = std::max(peaks_a2_[1], current_a2);
  snapshot_.totals.peak_a2 = std::max(peaks_a2_[0], peaks_a2_[1]);
}

void ControlTick::send(const device::BoardCommand& command) noexcept {
  last_ = command;
  port_.commands.write({++sent_, command});
}

bool ControlTick::publish(const Event& event) noexcept { return mailbox_.events.push(event); }

bool ControlTick::publish() noexcept {
  std::size_t published = 0;
  while (published < backlog_size_ && publish(backlog_[published])) ++published;
  std::copy(backlog_.begin() + static_cast<std::ptrdiff_t>(published),
            backlog_.begin() + static_cast<std::ptrdiff_t>(backlog_size_), backlog_.begin());
  backlog_size_ -= published;
  for (const Event& event : events_) {
    if (backlog_size_ == 0 && publish(event)) continue;
    const bool of_effect =
        event.type == EventType::kEffectStarted || event.type == EventType::kEffectEnded;
    const std::size_t capacity = of_effect ? kBacklog : kBacklog - kKeptForEffects;
    if (backlog_size_ < capacity) backlog_[backlog_size_++] = event;
  }
  return published > 0 || !events_.empty();
}

void ControlTick::shut_down() noexcept {
  controller_.end_all(EndReason::kStopped, events_);
  const bool unread = publish();
  controller_.fill(snapshot_);
  snapshot_.limited_a = {};
  mailbox_.status.write(snapshot_);
  if (unread) mailbox_.wake_io.raise();
}

bool ControlTick::run_safe() noexcept {
  device::BoardCommand safe;
  safe.fan = last_.fan;
  safe.arm_count = last_.arm_count;
  safe.boot_loader_count = last_.boot_loader_count;
  if (safe_since_ == 0) safe_since_ = port_.reports.read().telemetry_count;
  send(safe);
  // The second frame from now was measured after the command could have arrived; bridges that slept
  // throughout need no wait.
  const device::LinkReport& report = port_.reports.read();
  return report.present && report.telemetry_count >= safe_since_ + 4 &&
         !report.telemetry.bridges_awake;
}

}  // namespace hedgehog::control
