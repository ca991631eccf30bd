// SPDX-License-Identifier: MIT
// Results of a calibration, and the device file made from them.
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

/// An error that a device file cannot correct, as a sentence: winding `coil` was driven in both
/// directions, `forth_a` and `back_a` are the currents measured in all three windings,
/// `resistance_ohm` the result. "": none.
std::string winding_problem(int coil, const std::array<double, 3>& forth_a,
                            const std::array<double, 3>& back_a,
                            std::optional<double> resistance_ohm);

/// The side on which the pins came out when a winding was driven with a positive current.
struct PushedSides {
  std::array<std::string, 3> side;  // "front" … "down"; empty: unknown
};
/// Parses {"x=front", "y=left", "z=up"}, or nothing at all; nullopt: invalid, a winding is missing,
/// or two of them are on the same axis.
std::optional<PushedSides> read_pushed(const std::vector<std::string>& words);
/// The side for an answer such as "Left", " l", "le"; "": none.
std::string side_meant(std::string_view answer);
/// A winding before `winding` on the same axis, which is impossible.
std::optional<std::size_t> same_axis(const PushedSides& pushed, std::size_t winding);
/// One winding, or all three, are reversed relative to right-handed axes.
bool is_left_handed(const PushedSides& pushed);

struct Calibration {
  std::string name;
  std::array<double, 3> r25_ohm{};
  std::array<double, 3> inductance_h{};
  double sensor_c = 25.0;
  double current_a = 0.0;
  double supply_v = 0.0;
  PushedSides pushed;
  /// Relative standard deviation of `r25_ohm`, for a ball that was at one temperature.
  double resistance_share = 0.03;
  /// Why it was not, and the possible difference between thermometer and windings, K; "": it was.
  std::string unrest;
  double apart_k = 0.0;
  /// Of `calibrate --thermal`; nullopt: not measured.
  std::optional<model::ThermalFound> thermal;
};

/// Relative standard deviation of `r25_ohm` from all sources, clamped to the range of a device
/// file.
double resistance_uncertainty(const Calibration& measured);

/// The resulting coil matrix; nullopt: not all sides are known, or two are on one axis.
std::optional<std::array<model::Vec3, 3>> coil_matrix(const PushedSides& pushed);

/// JSON with comments, for devices.d. Values that were not measured are taken from `before`.
std::string device_file(const Calibration& measured, const protocol::Description& before);

}  // namespace hedgehog::client
