// SPDX-License-Identifier: MIT
// Description of the ball: the result of `device.describe`.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/limit/limits.h"
#include "model/thermal/thermal_model.h"
#include "model/thermal/thermal_uncertainty.h"
#include "model/vec3.h"

namespace hedgehog::protocol {

class Fields;

struct PinDescription {
  std::int64_t pin = 0;
  model::Vec3 position{};  // unit vector, device frame
  std::int64_t ring = 0;   // 0 is the top
  double rest_mm = 0.0;    // offset from the shell without current; 0: on it
  void describe(Fields& f);
  friend bool operator==(const PinDescription&, const PinDescription&) = default;
};

/// Resistance of a winding measured since the start; null: not yet.
struct WindingDescription {
  std::optional<double> r25_ohm{};
  /// Relative deviation from the device file's and from an earlier start's: 0.05 is 5 % more.
  std::optional<double> from_file{};
  std::optional<double> from_kept{};
  void describe(Fields& f);
  friend bool operator==(const WindingDescription&, const WindingDescription&) = default;
};

struct CoilsDescription {
  std::array<model::Vec3, 3> matrix{};  // rows; demand (device frame) -> winding currents
  std::array<double, 3> r25_ohm{};
  double inductance_h = 0.0;
  double supply_v = 0.0;
  std::optional<std::vector<WindingDescription>> measured{};  // absent: older daemon
  void describe(Fields& f);
  friend bool operator==(const CoilsDescription&, const CoilsDescription&) = default;
};

struct CalibrationDescription {
  double force_n_per_a = 0.0126;  // at the pin along the field
  void describe(Fields& f);
  friend bool operator==(const CalibrationDescription&, const CalibrationDescription&) = default;
};

struct BoardDescription {
  std::string backend{};  // "simulator", "usb"
  bool present = false;
  std::optional<std::string> serial{};
  std::optional<std::string> firmware{};
  std::optional<std::string> protocol{};  // of the board's frames, "1.2"; only if present
  void describe(Fields& f);
  friend bool operator==(const BoardDescription&, const BoardDescription&) = default;
};

struct ImuDescription {
  std::string type{};  // "simulator", "external", "none", ...
  bool present = false;
  void describe(Fields& f);
  friend bool operator==(const ImuDescription&, const ImuDescription&) = default;
};

struct Description {
  static constexpr std::string_view kSchema = "Description";
  std::string name{};
  std::string model{};
  bool simulated = false;
  std::string arrangement{};
  std::vector<PinDescription> pins{};
  CoilsDescription coils{};
  model::ThermalModel thermal{};  // without `fan_full_rpm`; `sensor_winding` is 0..2
  model::ThermalUncertainty uncertainty{};
  model::Limits limits{0, 0, 0, 0, 0, 0, 0, 0};  // none is assumed
  CalibrationDescription calibration{};
  double gain = 1.0;  // output.set_gain
  BoardDescription board{};
  ImuDescription imu{};
  void describe(Fields& f);
  friend bool operator==(const Description&, const Description&) = default;
};

void describe(Fields& f, model::ThermalModel& v);
void describe(Fields& f, model::ThermalUncertainty& v);
void describe(Fields& f, model::Limits& v);

}  // namespace hedgehog::protocol
