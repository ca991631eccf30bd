// SPDX-License-Identifier: MIT
// One ball as data: the content of its device file (config/devices.d/*.json). Read and checked by
// daemon/config; constant while a ball is armed.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/calibration.h"
#include "model/coils.h"
#include "model/limit/limits.h"
#include "model/magnets/ball_geometry.h"
#include "model/thermal/thermal_model.h"
#include "model/thermal/thermal_uncertainty.h"

namespace hedgehog::model {

struct UsbId {
  std::uint16_t vendor = 0;
  std::uint16_t product = 0;
  friend constexpr bool operator==(const UsbId&, const UsbId&) noexcept = default;
};

struct DeviceModel {
  /// Display name of this ball ("ball-7"); label `device` of the metrics.
  std::string name = "ball";
  /// The kind of ball; the name of its device file.
  std::string model = "hedgehog-86";
  BallGeometry geometry;
  CoilModel coils;
  ThermalModel thermal;
  /// Uncertainty of `thermal` and `coils.r25_ohm` for this ball.
  ThermalUncertainty uncertainty;
  /// Of the typical pin at its rest position (`PinCurves::typical_rest_mm`).
  double force_slope_n_a = kMeasuredCalibration.force_slope_n_a;
  /// Configuration may only tighten these.
  Limits limits;
  /// Boards that drive this kind of ball.
  std::vector<UsbId> usb{{0x1209, 0x0001}};
  /// Serial number of this ball's own board; empty: any board, provided exactly one is connected.
  std::string usb_serial;

  friend bool operator==(const DeviceModel&, const DeviceModel&) = default;
};

}  // namespace hedgehog::model
