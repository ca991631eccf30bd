// SPDX-License-Identifier: MIT
// What was measured on a ball, and the device file that says so.
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/identification/thermal_fit.h"
#include "protocol/values/description.h"

namespace hedgehog::client {

/// What no device file can mend, as a sentence: winding `coil` was driven one way and then the
/// other, `forth_a` and `back_a` were measured in all three, `resistance_ohm` follows. "": nothing.
std::string winding_trouble(int coil, const std::array<double, 3>& forth_a,
                            const std::array<double, 3>& back_a,
                            std::optional<double> resistance_ohm);

/// Which side the pins came out on when a winding was driven with a positive current.
struct PushedSides {
  std::array<std::string, 3> side;  // "front" … "down"; empty: nobody said
};
/// {"x=front", "y=left", "z=up"}, or nothing at all; nullopt: not so, a winding left out, or two of
/// them on the same axis.
std::optional<PushedSides> read_pushed(const std::vector<std::string>& words);
/// The side that a person means by "Left", " l", "le"; "": none.
std::string side_meant(std::string_view answer);
/// A winding before `winding` that pushes along the same axis, which cannot be.
std::optional<std::size_t> same_axis(const PushedSides& pushed, std::size_t winding);
/// One winding, or all three, the other way round than the axes want.
bool is_left_handed(const PushedSides& pushed);

struct Calibration {
  std::string name;
  std::array<double, 3> r25_ohm{};
  std::array<double, 3> inductance_h{};
  double sensor_c = 25.0;
  double current_a = 0.0;
  double supply_v = 0.0;
  PushedSides pushed;
  /// Standard deviation of `r25_ohm`, a share, for a ball that was at one temperature.
  double resistance_share = 0.03;
  /// Why it was not, and by how much the thermometer may differ from a winding, K; "": it was.
  std::string unrest;
  double apart_k = 0.0;
  /// Of `calibrate --thermal`; nullopt: not measured.
  std::optional<model::ThermalFound> thermal;
};

/// Standard deviation of `r25_ohm` with all that is known, within what a device file takes.
double resistance_uncertainty(const Calibration& measured);

/// The coil matrix that follows; nullopt: not all sides are known, or two are of one axis.
std::optional<std::array<model::Vec3, 3>> coil_matrix(const PushedSides& pushed);

/// JSON with comments, for devices.d. What was not measured is as the daemon's `before` says.
std::string device_file(const Calibration& measured, const protocol::Description& before);

}  // namespace hedgehog::client
