// SPDX-License-Identifier: MIT
// Resistance and inductance of a winding from samples of the board. Pure functions.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hedgehog::client {

/// With fewer samples noise or a stall of this computer could be mistaken for a winding or an open
/// circuit.
inline constexpr std::size_t kMinSamples = 20;

/// One millisecond of one winding: the current at its end, and the voltage during it.
struct WindingSample {
  double t_s = 0.0;
  double current_a = 0.0;
  double voltage_v = 0.0;
};

/// Relative standard error of the mean current, from the scatter of the currents.
double mean_error(const std::vector<WindingSample>& samples);

/// Ohm, from constant currents in both directions: a constant offset of the current sensor cancels.
/// nullopt: less than `min_a` in either direction.
std::optional<double> steady_resistance(const std::vector<WindingSample>& forth,
                                        const std::vector<WindingSample>& back,
                                        double min_a = 0.02);

/// Relative standard deviation of that, from the scatter of the currents. REQUIRES: it is known.
double steady_resistance_error(const std::vector<WindingSample>& forth,
                               const std::vector<WindingSample>& back);

struct Impedance {
  double resistance_ohm = 0.0;
  double inductance_h = 0.0;
};
/// From a stationary sine. The voltage V of each millisecond is constant, so with e = exp(-R T / L)
/// the current is I(t) = e I(t - T) + (1 - e) / R V: an equation of the two phasors for e and R.
/// The inductance is accurate if at least a tenth of the current remains after a millisecond (e >
/// 0.1). nullopt: they are not those of a winding.
std::optional<Impedance> sine_impedance(const std::vector<WindingSample>& samples,
                                        double frequency_hz);

/// Relative standard error of that inductance, from the scatter of currents and voltages around
/// their sines; infinite without an impedance, or if one so much off has none.
double inductance_error(const std::vector<WindingSample>& samples, double frequency_hz);

}  // namespace hedgehog::client
