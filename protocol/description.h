// SPDX-License-Identifier: MIT
// What the ball is: the answer to `device.describe`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/vec3.h"

namespace hedgehog::protocol {

struct PinDescription {
  std::int64_t pin = 0;
  model::Vec3 position{};  // unit vector, device frame
  std::int64_t ring = 0;   // 0 is the top
  double rest_mm = 0.0;    // out of the shell without current; 0: lies on it
  friend bool operator==(const PinDescription&, const PinDescription&) = default;
};

struct CoilsDescription {
  std::array<model::Vec3, 3> matrix{};  // rows; demand (device frame) -> winding currents
  std::array<double, 3> r25_ohm{};
  double inductance_h = 0.0;
  double supply_v = 0.0;
  friend bool operator==(const CoilsDescription&, const CoilsDescription&) = default;
};

struct LimitsDescription {
  double current_a = 0.0;
  double continuous_a = 0.0;
  double felt_a = 0.0;
  double derate_from_c = 0.0;
  double sustain_c = 0.0;
  double zero_c = 0.0;
  double trip_c = 0.0;
  double rearm_c = 0.0;
  friend bool operator==(const LimitsDescription&, const LimitsDescription&) = default;
};

struct CalibrationDescription {
  double force_n_per_a = 0.0126;  // at the pin that the field points to
  friend bool operator==(const CalibrationDescription&, const CalibrationDescription&) = default;
};

struct BoardDescription {
  std::string backend{};  // "simulator", "usb"
  bool present = false;
  std::optional<std::string> serial{};
  std::optional<std::string> firmware{};
  friend bool operator==(const BoardDescription&, const BoardDescription&) = default;
};

struct ImuDescription {
  std::string type{};  // "simulator", "external", "none", ...
  bool present = false;
  friend bool operator==(const ImuDescription&, const ImuDescription&) = default;
};

struct Description {
  std::string name{};
  std::string model{};
  bool simulated = false;
  std::string arrangement{};
  std::vector<PinDescription> pins{};
  CoilsDescription coils{};
  LimitsDescription limits{};
  CalibrationDescription calibration{};
  double gain = 1.0;  // output.set_gain
  BoardDescription board{};
  ImuDescription imu{};
  friend bool operator==(const Description&, const Description&) = default;
};

}  // namespace hedgehog::protocol
