// SPDX-License-Identifier: MIT
// Analogue electronics of the simulated board: converts true values to the converter readings that
// board_core/port.h gets on a real board. Figures, sources: README.md beside this file.
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

std::string_view name(FrontEndKind kind) noexcept;                           // "in_line"
std::optional<FrontEndKind> front_end_kind(std::string_view name) noexcept;  // nullopt: unknown

struct FrontEndParameters;

/// Choice of the simulated board. Trivially copyable.
struct FrontEndChoice {
  FrontEndKind kind = FrontEndKind::kInLine;
  int thermistors = 0;     // 1 or 3; 0: three with kInLine, one with the others
  std::uint64_t seed = 0;  // for parts drawn uniformly from their tolerances; 0: typical parts

  FrontEndParameters parameters() const noexcept;
};

/// One board's electronics. Trivially copyable.
struct FrontEndParameters {
  FrontEndKind kind = FrontEndKind::kInLine;
  board::Wiring wiring = board::reference_wiring();  // as assumed by the firmware

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
  std::array<double, model::kCoils> converted_before_s{};  // before the end of the millisecond

  double source_ohm = 0.0;  // of the supply and its leads
  double ripple_v = 0.0;    // amplitude at 100 Hz
};

/// Analogue inputs of the electronics at the end of a millisecond. Trivially copyable.
struct Analogue {
  model::Vec3 before_a;  // winding currents at the start of the millisecond
  model::Vec3 after_a;   // and at its end
  model::Vec3 duty;      // true duty of the bridges, -1..1; 0 is a brake
  bool awake = false;
  double supply_v = 12.0;
  std::array<double, model::kCoils> thermistor_c{25.0, 25.0, 25.0};  // fitted or not
  double thermistor_noise_k = 0.0;  // standard deviation of one reading
  double fan_rpm = 0.0;
};

/// Real-time safe, trivially copyable. Equal parameters, seeds and inputs give equal readings.
class FrontEnd {
 public:
  explicit FrontEnd(const FrontEndParameters& parameters, std::uint64_t seed = 1) noexcept
      : parameters_(parameters), noise_(seed) {}

  void convert(const Analogue& analogue, board::RawInputs& raw) noexcept;  // without thermistors
  /// Reading on `winding` with its offset and noise, C; and the converter's value for it.
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
