// SPDX-License-Identifier: MIT
#include "protocol/values/description.h"

#include <algorithm>

#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

void PinDescription::describe(Fields& f) {
  f.required("pin", pin);
  f.required("position", position, decimals(5));
  f.required("ring", ring);
  f.required("rest_mm", rest_mm, decimals(3));
}

void WindingDescription::describe(Fields& f) {
  f.nullable("r25_ohm", r25_ohm, decimals(4));
  f.nullable("from_file", from_file, decimals(4));
  f.nullable("from_kept", from_kept, decimals(4));
}

void CoilsDescription::describe(Fields& f) {
  std::vector<model::Vec3> rows(matrix.begin(), matrix.end());
  f.required("matrix", rows);
  for (std::size_t i = 0; i < matrix.size() && i < rows.size(); ++i) matrix[i] = rows[i];
  f.required("r25_ohm", r25_ohm);
  f.required("inductance_h", inductance_h);
  f.required("supply_v", supply_v);
  f.optional("measured", measured);
}

void describe(Fields& f, model::ThermalModel& v) {
  f.required("winding_j_k", v.winding_j_k);
  f.required("core_j_k", v.core_j_k);
  f.required("winding_to_core_k_w", v.winding_to_core_k_w);
  f.required("core_to_room_fan_k_w", v.core_to_ambient_fan_k_w);
  f.required("core_to_room_still_k_w", v.core_to_ambient_still_k_w);
  std::int64_t sensor_winding = v.sensor_winding;
  f.required("sensor_winding", sensor_winding);
  v.sensor_winding = static_cast<int>(std::clamp<std::int64_t>(sensor_winding, 0, 2));
  f.required("sensor_lag_s", v.sensor_lag_s);
}

void describe(Fields& f, model::ThermalUncertainty& v) {
  f.required("thermal", v.thermal);
  f.required("resistance", v.resistance);
  f.required("thermistor_k", v.thermistor_k);
}

void describe(Fields& f, model::Limits& v) {
  f.required("current_a", v.current_a);
  f.required("continuous_a", v.continuous_a);
  f.required("felt_a", v.felt_a);
  f.required("derate_from_c", v.derate_from_c);
  f.required("sustain_c", v.sustain_c);
  f.required("zero_c", v.zero_c);
  f.required("trip_c", v.trip_c);
  f.required("rearm_c", v.rearm_c);
}

void CalibrationDescription::describe(Fields& f) { f.required("force_n_per_a", force_n_per_a); }

void BoardDescription::describe(Fields& f) {
  f.required("backend", backend);
  f.required("present", present);
  f.nullable("serial", serial);
  f.nullable("firmware", firmware);
  f.nullable("protocol", protocol);
}

void ImuDescription::describe(Fields& f) {
  f.required("type", type);
  f.required("present", present);
}

void Description::describe(Fields& f) {
  f.required("name", name);
  f.required("model", model);
  f.required("simulated", simulated);
  f.required("arrangement", arrangement);
  f.required("pins", pins);
  f.required("coils", coils);
  f.required("thermal", thermal);
  f.required("uncertainty", uncertainty);
  f.required("limits", limits);
  f.required("calibration", calibration);
  f.required("gain", gain, decimals(4));
  f.required("board", board);
  f.required("imu", imu);
}

}  // namespace hedgehog::protocol
