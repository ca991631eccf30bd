// SPDX-License-Identifier: MIT
// The controller, the link and the simulated board in lock-step: one call is one millisecond of all
// three, computed as fast as possible. Tests and campaigns start effects, inject faults and read
// the plant's true state.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <vector>

#include "daemon/control/controller.h"
#include "daemon/control/recording/flight_recorder.h"
#include "daemon/device/link.h"
#include "daemon/device/simulator/simulated_board.h"
#include "model/random_stream.h"

namespace hedgehog::rig {

struct RigOptions {
  control::ControlSettings control = armed_at_start();
  device::SimulatedBoardOptions board;
  /// The board sends telemetry of protocol 1.0, which does not report which values are measured.
  bool first_protocol = false;

  static control::ControlSettings armed_at_start() noexcept {
    control::ControlSettings settings;
    settings.arm_at_start = true;
    settings.start_known = true;
    settings.start_measured.fill(true);
    return settings;
  }
};

/// A ball that differs from its device file by up to 20 % in every capacity, thermal resistance and
/// inductance, at 18..32 C ambient, with a thermistor that lags 1..3 s and has 0.15 K of noise.
device::SimulatedBoardOptions random_board(model::RandomStream& random) noexcept;

class Rig {
 public:
  explicit Rig(const RigOptions& options = {});

  /// One millisecond; `ticks` milliseconds; `seconds`.
  void tick();
  void run(model::Tick ticks);
  void run_s(double seconds) { run(std::llround(seconds * 1000.0)); }
  /// Ticks until `done()`, at most `max_ticks` times. False when it did not become true.
  template <class Done>
  bool run_until(Done done, model::Tick max_ticks) {
    for (model::Tick i = 0; i < max_ticks; ++i) {
      if (done()) return true;
      tick();
    }
    return done();
  }
  /// Runs until armed. REQUIRES: no arming blocker.
  void run_until_armed();
  /// The control thread sleeps for `ticks`, link and board continue; the next tick detects it.
  void skip_control(model::Tick ticks);
  /// Control and link sleep; only the board's own clock continues.
  void freeze_host(model::Tick ticks);

  /// Requests of clients; applied at the next tick.
  control::EffectId start(const model::EffectSpec& spec, control::EffectId replaces = 0);
  void update(control::EffectId effect, const model::EffectSpec& spec);
  void stop(control::EffectId effect,
            control::EndReason reason = control::EndReason::kStopped) noexcept;
  template <class What>
  void command(const What& what) {
    push({++seq_, what});
  }
  void arm() { command(control::Arm{inputs_.emergency_generation}); }
  void emergency_stop() noexcept { ++inputs_.emergency_generation; }
  /// Sets or clears faults of the simulated hardware now.
  void set_faults(std::uint16_t faults, int coil = 0);
  void set_ambient(double ambient_c);
  /// The next `frames` telemetry frames are lost in transfer.
  void drop_telemetry(int frames) noexcept { dropped_frames_ = frames; }
  /// The next telemetry frame arrives a tick late, together with the one after it.
  void delay_telemetry() noexcept { delay_ = true; }
  /// Sets the orientation, renewed each tick with a new time stamp while `live`.
  void orient(const model::Quaternion& device_to_world, bool live = true) noexcept;

  /// Sets the second thermometer's reading.
  void set_thermometer(double celsius) noexcept {
    inputs_.thermometer = {true, celsius, inputs_.tick};
  }

  model::Tick now() const noexcept { return inputs_.tick; }
  const control::Controller& controller() const noexcept { return controller_; }
  device::SimulatedBoard& board() noexcept { return board_; }
  const model::Plant& plant() const noexcept { return board_.plant(); }
  const device::Link& link() const noexcept { return link_; }
  const device::BoardCommand& last_command() const noexcept { return command_.board; }
  const control::StepInputs& last_inputs() const noexcept { return inputs_; }
  control::StatusSnapshot snapshot() const noexcept;
  bool playing(control::EffectId effect) const noexcept;
  /// |I| in the windings, true value.
  double current_a() const noexcept { return norm(board_.plant().current_a()); }

  /// All events since the start, or since `clear_events`.
  const std::vector<control::Event>& events() const noexcept { return log_; }
  void clear_events() noexcept { log_.clear(); }
  int count(control::EventType type) const noexcept;
  const control::Event* last(control::EventType type) const noexcept;

  /// Records every tick when set.
  control::FlightRecorder* recorder = nullptr;

 private:
  void push(const control::Command& command);
  void step_control();
  void step_link_and_board();

  control::Controller controller_;
  device::Link link_;
  device::SimulatedBoard board_;
  control::StepInputs inputs_;
  control::EventList events_;
  device::LinkCommand command_;
  std::vector<control::Command> queue_;
  std::vector<control::Event> log_;
  std::array<control::EffectId, control::kEffectPlaces> places_{};
  control::EffectId effects_ = 0;
  std::uint64_t seq_ = 0;
  std::uint64_t telemetry_count_ = 0;
  std::uint32_t skipped_ = 0;
  int dropped_frames_ = 0;
  bool delay_ = false;
  std::optional<device::Frame> delayed_;
  bool first_protocol_ = false;
  bool orientation_live_ = false;
};

/// Shorthands for the specs that tests use most.
model::EffectSpec hold(const model::Vec3& direction, double current_a, model::Tick lease = 10'000);
model::EffectSpec pulse(const model::Vec3& direction, double current_a, model::Tick duration);

}  // namespace hedgehog::rig
