// SPDX-License-Identifier: MIT
#include "tests/rig/rig.h"

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace hedgehog::rig {

using control::EffectId;
using model::Tick;

device::SimulatedBoardOptions random_board(model::RandomStream& random) noexcept {
  device::SimulatedBoardOptions options;
  model::PlantParameters& plant = options.plant;
  const auto off = [&](double& value) { value *= random.uniform(0.8, 1.2); };
  for (double& value : plant.winding_j_k) off(value);
  for (double& value : plant.winding_to_core_k_w) off(value);
  off(plant.core_j_k);
  off(plant.core_to_ambient_fan_k_w);
  off(plant.core_to_ambient_still_k_w);
  off(plant.inductance_h);
  plant.sensor_lag_s = random.uniform(1.0, 3.0);
  plant.sensor_noise_k = 0.15;
  plant.seed = random.bits();
  options.ambient_c = random.uniform(18.0, 32.0);
  options.start_c = options.ambient_c;
  return options;
}

namespace {

/// The telemetry of a board of protocol 1.0 for the same millisecond.
device::Frame of_first_protocol(const device::Frame& frame) noexcept {
  board::TelemetryFrame values = board::read_telemetry(frame.data());
  values.minor = 0;
  values.currents_measured = 0;
  values.thermistors = 0;
  values.currents_in_line = false;
  values.supply_current_measured = false;
  values.supply_ma = 0;
  values.other_thermistor = 0;
  values.other_cc = 0;
  device::Frame out;
  board::write_frame(values, out.data());
  return out;
}

}  // namespace

Rig::Rig(const RigOptions& options)
    : controller_(options.control), board_(options.board), first_protocol_(options.first_protocol) {
  queue_.reserve(4096);
  log_.reserve(4096);
}

void Rig::tick() {
  step_control();
  step_link_and_board();
}

void Rig::run(Tick ticks) {
  for (Tick i = 0; i < ticks; ++i) tick();
}

void Rig::run_until_armed() {
  const auto armed = [this] { return controller_.state() == control::State::kArmed; };
  if (!run_until(armed, 1000)) std::abort();
}

void Rig::skip_control(Tick ticks) {
  for (Tick i = 0; i < ticks; ++i) step_link_and_board();
  skipped_ += static_cast<std::uint32_t>(ticks);
}

void Rig::freeze_host(Tick ticks) {
  for (Tick i = 0; i < ticks; ++i) {
    link_.skip(1);
    if (const auto frame = board_.step()) link_.receive(*frame);
  }
  skipped_ += static_cast<std::uint32_t>(ticks);
}

void Rig::step_control() {
  inputs_.tick += 1 + static_cast<Tick>(skipped_);
  inputs_.skipped = skipped_;
  skipped_ = 0;
  const device::LinkReport& report = link_.report();
  inputs_.board_present = report.present;
  inputs_.board_fresh = report.telemetry_count != telemetry_count_;
  inputs_.board = report.telemetry;
  telemetry_count_ = report.telemetry_count;
  if (orientation_live_) inputs_.orientation.stamp = inputs_.tick;
  const auto taken = std::min<std::size_t>(queue_.size(), control::kMaxCommandsPerTick);
  std::copy_n(queue_.begin(), taken, inputs_.commands.begin());
  inputs_.command_count = static_cast<std::uint16_t>(taken);
  queue_.erase(queue_.begin(), queue_.begin() + static_cast<std::ptrdiff_t>(taken));

  if (recorder != nullptr) recorder->before(controller_, inputs_);
  command_.board = controller_.step(inputs_, events_);
  if (recorder != nullptr) recorder->after(controller_, command_.board, events_);
  ++command_.count;
  inputs_.stop_count = 0;
  for (const control::Event& event : events_) {
    log_.push_back(event);
    if (event.type == control::EventType::kEffectEnded) places_[event.place] = 0;
  }
}

void Rig::step_link_and_board() {
  const device::LinkFrames frames = link_.step(command_);
  board_.receive(frames.set_point);
  if (frames.other) board_.receive(*frames.other);
  auto telemetry = board_.step();
  if (telemetry && first_protocol_) telemetry = of_first_protocol(*telemetry);
  if (dropped_frames_ > 0) {
    --dropped_frames_;
  } else if (telemetry && std::exchange(delay_, false)) {
    delayed_ = telemetry;
  } else if (telemetry) {
    if (delayed_) link_.receive(*std::exchange(delayed_, std::nullopt));
    link_.receive(*telemetry);
  }
}

void Rig::push(const control::Command& command) { queue_.push_back(command); }

EffectId Rig::start(const model::EffectSpec& spec, EffectId replaces) {
  const auto place = [this](EffectId effect) {
    const auto at = std::find(places_.begin(), places_.end(), effect);
    return static_cast<std::uint8_t>(at - places_.begin());
  };
  control::StartEffect start;
  start.effect = ++effects_;
  start.place = place(0);
  if (start.place >= control::kEffectPlaces) return 0;
  start.replaces = replaces;
  start.replaces_place = replaces == 0 ? std::uint8_t{0} : place(replaces);
  start.spec = spec;
  places_[start.place] = start.effect;
  command(start);
  return start.effect;
}

void Rig::update(EffectId effect, const model::EffectSpec& spec) {
  const auto at = std::find(places_.begin(), places_.end(), effect);
  if (at == places_.end()) return;
  command(control::UpdateEffect{effect, static_cast<std::uint8_t>(at - places_.begin()), spec});
}

void Rig::stop(EffectId effect, control::EndReason reason) noexcept {
  const auto at = std::find(places_.begin(), places_.end(), effect);
  if (at == places_.end() || inputs_.stop_count >= control::kEffectPlaces) return;
  inputs_.stops[inputs_.stop_count++] = {effect, static_cast<std::uint8_t>(at - places_.begin()),
                                         reason};
}

void Rig::set_faults(std::uint16_t faults, int coil) {
  device::SimulatorSettings settings = board_.settings();
  settings.faults = faults;
  settings.coil = static_cast<std::uint8_t>(coil);
  board_.apply(settings);
}

void Rig::set_ambient(double ambient_c) {
  device::SimulatorSettings settings = board_.settings();
  settings.ambient_c = ambient_c;
  board_.apply(settings);
}

void Rig::orient(const model::Quaternion& device_to_world, bool live) noexcept {
  inputs_.orientation.present = true;
  inputs_.orientation.quaternion = device_to_world;
  if (live || orientation_live_) inputs_.orientation.stamp = inputs_.tick;
  orientation_live_ = live;
}

control::StatusSnapshot Rig::snapshot() const noexcept {
  control::StatusSnapshot snapshot;
  controller_.fill(snapshot);
  return snapshot;
}

bool Rig::playing(EffectId effect) const noexcept {
  return effect != 0 && std::find(places_.begin(), places_.end(), effect) != places_.end();
}

int Rig::count(control::EventType type) const noexcept {
  return static_cast<int>(std::count_if(
      log_.begin(), log_.end(), [&](const auto& event) { return event.type == type; }));
}

const control::Event* Rig::last(control::EventType type) const noexcept {
  const auto at = std::find_if(log_.rbegin(), log_.rend(),
                               [&](const auto& event) { return event.type == type; });
  return at == log_.rend() ? nullptr : &*at;
}

model::EffectSpec hold(const model::Vec3& direction, double current_a, Tick lease) {
  model::EffectSpec spec;
  spec.method = model::EffectMethod::kHold;
  spec.trajectory.direction = unit_or(direction, {1, 0, 0});
  spec.strength_a = current_a;
  spec.duration = 0;
  spec.lease = lease;
  return spec;
}

model::EffectSpec pulse(const model::Vec3& direction, double current_a, Tick duration) {
  model::EffectSpec spec;
  spec.trajectory.direction = unit_or(direction, {1, 0, 0});
  spec.strength_a = current_a;
  spec.duration = duration;
  return spec;
}

}  // namespace hedgehog::rig
