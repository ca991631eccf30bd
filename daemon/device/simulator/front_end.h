// SPDX-License-Identifier: MIT
// Analogue electronics between the simulated ball and its microcontroller: converts the true values
// to the converter readings that board_core/port.h gets on a real board. Figures and their sources:
// README.md beside this file.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "daemon/device/board_core/port.h"
#include "model/coils.h"
#include "model/random_stream.h"
#include "model/vec3.h"

namespace hedgehog::device {

/// Kind of electronics (`simulator.front_end`).
enum class FrontEndKind : std::uint8_t {
  kInLine,    // the reference board: shunts in the windings' leads, a separate converter
  kDriverCs,  // the thesis' drivers with their own CS pins
  kIdeal,     // no electronics: the rules of the board get the true values, to 1 mA
};

/// "in_line". nullopt: no such kind.
std::string_view name(FrontEndKind kind) noexcept;
std::optional<FrontEndKind> front_end_kind(std::string_view name) noexcept;

struct FrontEndParameters;

/// Choice of the simulated board. Trivially copyable.
struct FrontEndChoice {
  FrontEndKind kind = FrontEndKind::kInLine;
  /// 1 or 3; 0: three with kInLine, one with the others.
  int thermistors = 0;
  /// Seed for parts drawn uniformly from their tolerances; 0: typical parts.
  std::uint64_t seed = 0;

  FrontEndParameters parameters() const noexcept;
};

/// One board's electronics. Trivially copyable.
struct FrontEndParameters {
  FrontEndKind kind = FrontEndKind::kInLine;
  /// The electronics as assumed by the firmware.
  board::Wiring wiring = board::reference_wiring();

  /// Deviations from that: each reading is true x gain + offset, A and K.
  std::array<double, model::kCoils> current_gain{1.0, 1.0, 1.0};
  std::array<double, model::kCoils> current_offset_a{};
  double supply_gain = 1.0;
  double shunt_gain = 1.0;
  double shunt_offset_a = 0.0;
  std::array<double, model::kCoils> thermistor_offset_k{};

  /// Standard deviations of one conversion.
  double current_noise_a = 0.0;
  double shunt_noise_a = 0.0;
  double supply_noise_v = 0.0;
  /// The currents are converted sequentially, this long before the end of the millisecond.
  std::array<double, model::kCoils> converted_before_s{};

  /// The supply: its resistance including the leads, and the amplitude of its ripple at 100 Hz.
  double source_ohm = 0.0;
  double ripple_v = 0.0;
};

/// Analogue inputs of the electronics at the end of a millisecond. Trivially copyable.
struct Analogue {
  /// Winding currents at the start and end of the millisecond, A.
  model::Vec3 before_a;
  model::Vec3 after_a;
  /// True duty of the bridges, -1..1; 0 is a brake.
  model::Vec3 duty;
  bool awake = false;
  double supply_v = 12.0;
  /// Temperatures of the thermistors, C, on each winding whether fitted or not.
  std::array<double, model::kCoils> thermistor_c{25.0, 25.0, 25.0};
  /// Standard deviation of one reading, K.
  double thermistor_noise_k = 0.0;
  double fan_rpm = 0.0;
};

/// Real-time safe and trivially copyable; no thread of its own. Equal parameters, seeds and inputs
/// give equal readings.
class FrontEnd {
 public:
  explicit FrontEnd(const FrontEndParameters& parameters, std::uint64_t seed = 1) noexcept
      : parameters_(parameters), noise_(seed) {}

  /// Converts currents, supply and tach to converter and timer values.
  void convert(const Analogue& analogue, board::RawInputs& raw) noexcept;
  /// Reading of the thermistor on `winding`, with its offset and noise, C; and the converter's
  /// value for it.
  double thermistor_c(const Analogue& analogue, int winding) noexcept;
  std::uint16_t ntc_adc(double celsius) const noexcept;

  /// Current drawn by the bridges from the supply, A, less that returned by braking ones.
  static double drawn_a(const Analogue& analogue) noexcept;

  const FrontEndParameters& parameters() const noexcept { return parameters_; }
  FrontEndParameters& parameters() noexcept { return parameters_; }

 private:
  double current_uv(const Analogue& analogue, int coil) noexcept;
  std::uint16_t adc(double microvolts) const noexcept;

  FrontEndParameters parameters_;
  model::RandomStream noise_;
};

}  // namespace hedgehog::device
