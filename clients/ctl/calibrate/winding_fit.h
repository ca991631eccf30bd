// SPDX-License-Identifier: MIT
// Resistance and inductance of a winding from what the board measured of it. Pure functions.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

namespace hedgehog::client {

/// Fewer samples would make noise a winding, or a stall of this computer an empty plug.
inline constexpr std::size_t kMinSamples = 20;

/// One millisecond of one winding: the current at its end, and the voltage during it.
struct WindingSample {
  double t_s = 0.0;
  double current_a = 0.0;
  double voltage_v = 0.0;
};

/// Ohm, from a steady current one way and then the other: a constant error of the current sensor
/// falls out. nullopt: not even `min_a` flowed each way.
std::optional<double> steady_resistance(const std::vector<WindingSample>& forth,
                                        const std::vector<WindingSample>& back,
                                        double min_a = 0.02);

/// Standard deviation of that, a share, by the scatter of the currents. REQUIRES: it is known.
double steady_resistance_error(const std::vector<WindingSample>& forth,
                               const std::vector<WindingSample>& back);

struct Impedance {
  double resistance_ohm = 0.0;
  double inductance_h = 0.0;
};
/// From a steady sine. Each millisecond's voltage V is constant, so with e = exp(-R T / L) the
/// current is I(t) = e I(t - T) + (1 - e) / R V: of the two phasors, an equation for e and R.
/// The inductance is good as long as a tenth of the current outlives the millisecond (e > 0.1).
/// nullopt: they are not those of a winding.
std::optional<Impedance> sine_impedance(const std::vector<WindingSample>& samples,
                                        double frequency_hz);

}  // namespace hedgehog::client
