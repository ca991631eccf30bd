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
  std::string name = "ball";          // display name ("ball-7"); label `device` of the metrics
  std::string model = "hedgehog-86";  // the kind of ball; the name of its device file
  BallGeometry geometry;
  CoilModel coils;
  ThermalModel thermal;
  ThermalUncertainty uncertainty;  // of `thermal` and `coils.r25_ohm`
  /// Of the typical pin at its rest position (`PinCurves::typical_rest_mm`).
  double force_slope_n_a = kMeasuredCalibration.force_slope_n_a;
  Limits limits;                             // configuration may only tighten these
  std::vector<UsbId> usb{{0x1209, 0x0001}};  // boards that drive this kind of ball
  std::string usb_serial;  // of this ball's own board; empty: any, if exactly one is connected

  friend bool operator==(const DeviceModel&, const DeviceModel&) = default;
};

}  // namespace hedgehog::model
