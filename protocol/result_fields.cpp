// SPDX-License-Identifier: MIT
#include "protocol/describe.h"

namespace hedgehog::protocol {

void describe(Fields& f, HelloDevice& v) {
  f.required("name", v.name);
  f.required("model", v.model);
  f.required("simulated", v.simulated);
}

void describe(Fields& f, HelloLimits& v) {
  f.required("current_a", v.current_a);
  f.required("continuous_a", v.continuous_a);
  f.required("felt_a", v.felt_a);
  f.required("duration_ms", v.duration_ms);
  f.required("lease_ms", v.lease_ms);
  f.required("effects", v.effects);
  f.required("frequency_hz", v.frequency_hz);
  f.required("telemetry_hz", v.telemetry_hz);
  f.required("line_bytes", v.line_bytes);
  f.optional("burst_s", v.burst_s, decimals(1));
}

void describe(Fields& f, HelloResult& v) {
  f.required("server", v.server);
  f.required("version", v.version);
  f.required("protocol", v.protocol);
  f.required("connection", v.connection);
  f.required("role", v.role);
  f.required("state", v.state);
  f.nullable("reason", v.reason);
  f.nullable("remedy", v.remedy);
  f.required("methods", v.methods);
  f.required("device", v.device);
  f.required("limits", v.limits);
}

void describe(Fields& f, PingResult& v) { f.required("time_ns", v.time_ns); }

void describe(Fields& f, Admission& v) {
  f.required("effect", v.effect);
  f.optional("slot", v.slot);
  f.required("accepted", v.accepted);
  f.nullable("limited_by", v.limited_by);
  f.required("current_a", v.current_a, decimals(2));
  f.required("force_n", v.force_n, decimals(4));
  f.required("pin", v.pin);
  f.nullable("headroom_s", v.headroom_s, decimals(1));
  f.required("seq", v.seq);
  f.optional("period_ms", v.period_ms, decimals(3));
}

void describe(Fields& f, StopResult& v) {
  f.required("stopped", v.stopped);
  f.required("seq", v.seq);
}

void describe(Fields& f, StateResult& v) {
  f.required("state", v.state);
  f.nullable("reason", v.reason);
  f.nullable("remedy", v.remedy);
  f.required("seq", v.seq);
}

void describe(Fields& f, ClaimResult& v) { f.required("lease_ms", v.lease_ms); }

void describe(Fields& f, GainResult& v) {
  f.required("gain", v.gain, decimals(4));
  f.required("seq", v.seq);
}

void describe(Fields& f, ForecastResult& v) {
  f.nullable("seconds_to_derating", v.seconds_to_derating, decimals(1));
  f.nullable("seconds_to_limit", v.seconds_to_limit, decimals(1));
  f.required("sustainable_a", v.sustainable_a, decimals(2));
  f.nullable("recovery_s", v.recovery_s, decimals(1));
}

void describe(Fields& f, RecenterResult& v) {
  f.required("yaw_offset_deg", v.yaw_offset_deg, decimals(2));
}

void describe(Fields& f, EventsResult& v) {
  f.required("state", v.state);
  f.nullable("reason", v.reason);
  f.required("derating", v.derating);
  f.required("limit_a", v.limit_a, decimals(2));
}

void describe(Fields& f, ConnectionInfo& v) {
  f.required("connection", v.connection);
  f.nullable("client", v.client);
  f.required("transport", v.transport);
  f.nullable("address", v.address);
  f.required("role", v.role);
  f.required("since_s", v.since_s, decimals(1));
  f.required("claimed", v.claimed);
  f.required("effects", v.effects);
}

void describe(Fields& f, ConnectionsResult& v) { f.required("connections", v.connections); }

void describe(Fields& f, SeenDevice& v) {
  f.required("path", v.path);
  f.required("ids", v.ids);
  f.required("name", v.name);
  f.nullable("serial", v.serial);
  f.nullable("firmware", v.firmware);
  f.nullable("use", v.use);
  f.nullable("why_not", v.why_not);
}

void describe(Fields& f, MissingDevice& v) {
  f.required("use", v.use);
  f.required("why", v.why);
}

void describe(Fields& f, DevicesResult& v) {
  f.required("devices", v.devices);
  f.required("missing", v.missing);
  f.required("others", v.others);
}

void describe(Fields& f, PreviewResult& v) {
  constexpr std::size_t kSteps = PreviewResult::kMaxSteps;
  f.required("duration_ms", v.duration_ms);
  f.required("step_ms", v.step_ms);
  f.required("duty", v.duty, {.decimals = 4, .items = kSteps});
  f.required("current_a", v.current_a, {.decimals = 3, .items = kSteps});
  f.required("peak_current_a", v.peak_current_a, decimals(3));
  f.required("temperature_c", v.temperature_c, decimals(2));
  f.required("peak_temperature_c", v.peak_temperature_c, decimals(2));
  f.nullable("limited_by", v.limited_by);
  f.nullable("limited_from_ms", v.limited_from_ms);
  f.required("delivered", v.delivered);
}

void describe(Fields& f, SimResult& v) {
  f.required("ambient_c", v.ambient_c, decimals(2));
  f.required("faults", v.faults);
  f.required("coil", v.coil);
  f.required("errors", v.errors, {.items = kMaxSimErrors});
}

void describe(Fields& f, SimTruthResult& v) {
  f.required("coils_c", v.coils_c, decimals(3));
  f.required("core_c", v.core_c, decimals(3));
  f.required("skin_c", v.skin_c, decimals(3));
  f.required("current_a", v.current_a, decimals(3));
  f.required("ambient_c", v.ambient_c, decimals(2));
}

void describe(Fields& f, PinDescription& v) {
  f.required("pin", v.pin);
  f.required("position", v.position, decimals(5));
  f.required("ring", v.ring);
  f.required("rest_mm", v.rest_mm, decimals(3));
}

void describe(Fields& f, WindingDescription& v) {
  f.nullable("r25_ohm", v.r25_ohm, decimals(4));
  f.nullable("from_file", v.from_file, decimals(4));
  f.nullable("from_kept", v.from_kept, decimals(4));
}

void describe(Fields& f, CoilsDescription& v) {
  std::vector<model::Vec3> rows(v.matrix.begin(), v.matrix.end());
  f.required("matrix", rows);
  for (std::size_t i = 0; i < v.matrix.size() && i < rows.size(); ++i) v.matrix[i] = rows[i];
  f.required("r25_ohm", v.r25_ohm);
  f.required("inductance_h", v.inductance_h);
  f.required("supply_v", v.supply_v);
  f.optional("measured", v.measured);
}

void describe(Fields& f, ThermalDescription& v) {
  f.required("winding_j_k", v.winding_j_k);
  f.required("core_j_k", v.core_j_k);
  f.required("winding_to_core_k_w", v.winding_to_core_k_w);
  f.required("core_to_room_fan_k_w", v.core_to_room_fan_k_w);
  f.required("core_to_room_still_k_w", v.core_to_room_still_k_w);
  f.required("sensor_winding", v.sensor_winding);
  f.required("sensor_lag_s", v.sensor_lag_s);
}

void describe(Fields& f, UncertaintyDescription& v) {
  f.required("thermal", v.thermal);
  f.required("resistance", v.resistance);
  f.required("thermistor_k", v.thermistor_k);
}

void describe(Fields& f, LimitsDescription& v) {
  f.required("current_a", v.current_a);
  f.required("continuous_a", v.continuous_a);
  f.required("felt_a", v.felt_a);
  f.required("derate_from_c", v.derate_from_c);
  f.required("sustain_c", v.sustain_c);
  f.required("zero_c", v.zero_c);
  f.required("trip_c", v.trip_c);
  f.required("rearm_c", v.rearm_c);
}

void describe(Fields& f, CalibrationDescription& v) {
  f.required("force_n_per_a", v.force_n_per_a);
}

void describe(Fields& f, BoardDescription& v) {
  f.required("backend", v.backend);
  f.required("present", v.present);
  f.nullable("serial", v.serial);
  f.nullable("firmware", v.firmware);
}

void describe(Fields& f, ImuDescription& v) {
  f.required("type", v.type);
  f.required("present", v.present);
}

void describe(Fields& f, Description& v) {
  f.required("name", v.name);
  f.required("model", v.model);
  f.required("simulated", v.simulated);
  f.required("arrangement", v.arrangement);
  f.required("pins", v.pins);
  f.required("coils", v.coils);
  f.required("thermal", v.thermal);
  f.required("uncertainty", v.uncertainty);
  f.required("limits", v.limits);
  f.required("calibration", v.calibration);
  f.required("gain", v.gain, decimals(4));
  f.required("board", v.board);
  f.required("imu", v.imu);
}

}  // namespace hedgehog::protocol
