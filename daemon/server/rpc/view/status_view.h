// SPDX-License-Identifier: MIT
// The status object of the protocol from the control thread's snapshot.
#pragma once

#include <cstdint>
#include <optional>

#include "daemon/server/device/device_view.h"
#include "daemon/server/effects/effect_registry.h"
#include "protocol/values/status.h"

namespace hedgehog::server {

/// io thread only. Forecasts take up to milliseconds, so they are cached for a twentieth of a
/// second of device time.
class StatusView {
 public:
  StatusView(const DeviceView& device_view, EffectRegistry& effects)
      : device_view_(device_view), effects_(effects) {}

  /// `with_pins`: includes the effect of the measured currents on every pin.
  protocol::Status status(bool with_pins);
  protocol::EffectStatus effect(const Effect& effect) const;

 private:
  void refresh_forecast();
  model::PinMotion pins() const;

  const DeviceView& device_view_;
  EffectRegistry& effects_;
  model::Tick forecast_tick_ = -1'000'000;
  std::optional<double> headroom_s_;
  std::optional<double> burst_s_;
};

/// The present field, A, device frame.
model::Vec3 field_now(const DeviceView& device_view);

}  // namespace hedgehog::server
