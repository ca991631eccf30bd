// SPDX-License-Identifier: MIT
#include "daemon/device/simulator/front_end.h"

#include <algorithm>
#include <cmath>

#include "model/tick.h"

namespace hedgehog::device {
namespace {

using model::kCoils;

constexpr double kNtcOhm = 10'000.0;  // at 25 C
constexpr double kNtcB = 3950.0;
constexpr double kKelvin = 273.15;
// In the order of FrontEndKind.
constexpr std::array<std::string_view, 3> kFrontEndKinds{"in_line", "driver_cs", "ideal"};

// Tolerances of parts that remain after a calibration.
constexpr double kGain = 0.02;
constexpr double kInLineOffsetA = 0.02;
constexpr double kDriverCsOffsetA = 0.10;
constexpr double kShuntOffsetA = 0.03;
constexpr double kThermistorK = 1.0;

double random_gain(model::RandomStream& random) noexcept {
  return random.uniform(1.0 - kGain, 1.0 + kGain);
}

void draw_parts(FrontEndParameters& p, std::uint64_t seed) noexcept {
  // A stream other than that of the noise with the same seed.
  model::RandomStream random(~seed);
  const double offset_a = p.kind == FrontEndKind::kInLine ? kInLineOffsetA : kDriverCsOffsetA;
  for (std::size_t i = 0; i < kCoils; ++i) {
    p.current_gain[i] = random_gain(random);
    p.current_offset_a[i] = random.uniform(-offset_a, offset_a);
    p.thermistor_offset_k[i] = random.uniform(-kThermistorK, kThermistorK);
  }
  p.supply_gain = random_gain(random);
  p.shunt_gain = random_gain(random);
  p.shunt_offset_a = random.uniform(-kShuntOffsetA, kShuntOffsetA);
}

}  // namespace

std::string_view name(FrontEndKind kind) noexcept {
  return kFrontEndKinds[static_cast<std::size_t>(kind)];
}

std::optional<FrontEndKind> front_end_kind(std::string_view name) noexcept {
  for (std::size_t i = 0; i < kFrontEndKinds.size(); ++i)
    if (kFrontEndKinds[i] == name) return static_cast<FrontEndKind>(i);
  return std::nullopt;
}

FrontEndParameters FrontEndChoice::parameters() const noexcept {
  const bool in_line = kind == FrontEndKind::kInLine;
  FrontEndParameters p;
  p.kind = kind;
  if (!in_line) p.wiring = board::Wiring{};
  p.wiring.thermistors = static_cast<std::uint8_t>(thermistors != 0 ? thermistors
                                                   : in_line        ? 3
                                                                    : 1);
  if (kind == FrontEndKind::kIdeal) return p;
  p.wiring.shunt_uv_per_a = board::reference_wiring().shunt_uv_per_a;
  p.source_ohm = 0.02;
  p.ripple_v = 0.03;
  p.supply_noise_v = 0.005;
  p.shunt_noise_a = 0.02;
  p.current_noise_a = in_line ? 0.04 : 0.10;
  if (in_line)
    for (std::size_t i = 0; i < kCoils; ++i)
      p.converted_before_s[i] = 1e-6 * p.wiring.converted_before_us[i];
  if (seed != 0) draw_parts(p, seed);
  return p;
}

double FrontEnd::drawn_a(const Analogue& analogue) noexcept {
  if (!analogue.awake) return 0.0;
  const double sum = dot(analogue.duty, 0.5 * (analogue.before_a + analogue.after_a));
  return std::max(0.0, sum);
}

std::uint16_t FrontEnd::adc(double microvolts) const noexcept {
  const board::Wiring& wiring = parameters_.wiring;
  const double full = wiring.adc_full;
  const double counts = microvolts * 1e-3 / wiring.adc_reference_mv * full;
  return static_cast<std::uint16_t>(std::lround(std::clamp(counts, 0.0, full)));
}

std::uint16_t FrontEnd::ntc_adc(double celsius) const noexcept {
  const board::Wiring& wiring = parameters_.wiring;
  // Below this the thermistor's curve is unknown, and at 0 K it diverges.
  constexpr double kColdestC = -60.0;
  celsius = std::max(celsius, kColdestC);
  const double ohm =
      kNtcOhm * std::exp(kNtcB * (1.0 / (celsius + kKelvin) - 1.0 / (25.0 + kKelvin)));
  const double share = ohm / (ohm + wiring.ntc_pull_up_ohm);
  return static_cast<std::uint16_t>(std::lround(wiring.adc_full * share));
}

double FrontEnd::current_uv(const Analogue& analogue, int coil) noexcept {
  const auto i = static_cast<std::size_t>(coil);
  const board::Wiring& wiring = parameters_.wiring;
  const double uv_per_a = wiring.current_uv_per_a[i];
  const double disturbed_a =
      parameters_.current_offset_a[i] + parameters_.current_noise_a * noise_.gaussian();
  const double slope_a_s = (analogue.after_a[coil] - analogue.before_a[coil]) / model::kTickSeconds;
  const double true_a = analogue.after_a[coil] - parameters_.converted_before_s[i] * slope_a_s;
  double shown_a = true_a;
  if (wiring.current_sense == board::CurrentSense::kDriverCs) {
    // The shunt is in the bridge's ground: it measures the winding current while the bridge drives,
    // in the bridge's direction. An on-time too short to settle gives a part of it.
    const double duty = analogue.awake ? analogue.duty[coil] : 0.0;
    const double lowest = board::kMinSampledDutyQ15 / 32767.0;
    const double settled = std::min(1.0, std::abs(duty) / lowest);
    shown_a = settled * (duty < 0.0 ? -true_a : true_a);
  }
  return wiring.current_zero_uv[i] +
         uv_per_a * (parameters_.current_gain[i] * shown_a + disturbed_a);
}

void FrontEnd::convert(const Analogue& analogue, board::RawInputs& raw) noexcept {
  const board::Wiring& wiring = parameters_.wiring;
  for (int coil = 0; coil < kCoils; ++coil) raw.current_adc[coil] = adc(current_uv(analogue, coil));
  const double supply_v =
      parameters_.supply_gain * analogue.supply_v + parameters_.supply_noise_v * noise_.gaussian();
  const double lower = wiring.supply_lower_ohm;
  raw.supply_adc = adc(1e6 * supply_v * lower / (lower + wiring.supply_upper_ohm));
  const double drawn = parameters_.shunt_gain * drawn_a(analogue) + parameters_.shunt_offset_a +
                       parameters_.shunt_noise_a * noise_.gaussian();
  raw.shunt_adc = adc(wiring.shunt_uv_per_a * drawn);
  // Below this the interval of the fan's edges exceeds the timer's timeout.
  constexpr double kSlowestRpm = 120.0;
  raw.tach_period_us =
      analogue.fan_rpm < kSlowestRpm ? 0u : static_cast<std::uint32_t>(30e6 / analogue.fan_rpm);
}

double FrontEnd::thermistor_c(const Analogue& analogue, int winding) noexcept {
  const auto i = static_cast<std::size_t>(winding);
  return analogue.thermistor_c[i] + parameters_.thermistor_offset_k[i] +
         analogue.thermistor_noise_k * noise_.gaussian();
}

}  // namespace hedgehog::device
