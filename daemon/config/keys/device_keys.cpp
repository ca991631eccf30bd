// SPDX-License-Identifier: MIT
#include "daemon/config/keys/device_keys.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>
#include <utility>

#include "base/keys/json_text.h"
#include "base/keys/key_tree.h"
#include "daemon/config/keys/limit_keys.h"
#include "daemon/device/sensors/discovery.h"
#include "model/thermal/thermal_decay.h"

namespace hedgehog::config {

using namespace keys;

namespace {

using model::DeviceModel;

Reason read_three(const Value& value, double min, double max, std::array<double, 3>& out,
                  const std::string& what) {
  if (value.kind != Value::Kind::kArray || value.elements.size() != 3) return must_be(what, value);
  for (std::size_t i = 0; i < 3; ++i) {
    const Reason reason = read_number(value.elements[i], min, max, out[i]);
    if (!reason.empty()) return "number " + std::to_string(i + 1) + " " + reason;
  }
  return {};
}

Value three(double a, double b, double c) {
  return Value::array({Value::of(a), Value::of(b), Value::of(c)});
}

Reason read_matrix(DeviceModel& device, const Value& value) {
  const std::string shape =
      "three rows of three numbers, such as [[1, 0, 0], [0, 1, 0], [0, 0, 1]]";
  if (value.kind != Value::Kind::kArray || value.elements.size() != 3) return must_be(shape, value);
  model::Mat3 matrix;
  for (std::size_t r = 0; r < 3; ++r) {
    std::array<double, 3> row{};
    const Reason reason = read_three(value.elements[r], -10.0, 10.0, row, shape);
    if (!reason.empty()) return "row " + std::to_string(r + 1) + ": " + reason;
    matrix.row[r] = {row[0], row[1], row[2]};
  }
  // A calibrated matrix is close to a signed permutation, with a determinant close to 1 or -1.
  if (const double det = model::determinant(matrix); !(std::abs(det) >= 0.001))
    return "must have a determinant other than 0: the coils do not span all directions";
  device.coils.matrix = matrix;
  return {};
}

Value write_matrix(const DeviceModel& device) {
  std::vector<Value> rows;
  for (const model::Vec3& row : device.coils.matrix.row) rows.push_back(three(row.x, row.y, row.z));
  return Value::array(std::move(rows));
}

/// A number for all windings, or one for each.
template <class Get>
Key<DeviceModel> windings_key(std::string path, double min, double max, Get get) {
  return {std::move(path),
          [=](DeviceModel& d, const Value& v) -> Reason {
            if (v.kind == Value::Kind::kArray)
              return read_three(v, min, max, get(d), "one number, or three: of x, y, z");
            double common = 0.0;
            Reason reason = read_number(v, min, max, common);
            if (reason.empty()) get(d).fill(common);
            return reason;
          },
          [=](const DeviceModel& d) {
            const std::array<double, 3>& each = get(d);
            const bool common = each[0] == each[1] && each[1] == each[2];
            return common ? Value::of(each[0]) : three(each[0], each[1], each[2]);
          }};
}

bool parse_hex4(std::string_view digits, std::uint16_t& out) {
  const char* end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, out, 16);
  return digits.size() == 4 && error == std::errc() && stop == end;
}

Reason read_usb(DeviceModel& device, const Value& value) {
  const std::string shape = R"(a list of "vendor:product" in hexadecimal, such as ["1209:0001"])";
  if (value.kind != Value::Kind::kArray) return must_be(shape, value);
  std::vector<model::UsbId> ids;
  for (const Value& element : value.elements) {
    model::UsbId id;
    const std::string_view text = element.text;
    if (element.kind != Value::Kind::kText || text.size() != 9 || text[4] != ':' ||
        !parse_hex4(text.substr(0, 4), id.vendor) || !parse_hex4(text.substr(5), id.product))
      return must_be(shape, element);
    ids.push_back(id);
  }
  device.usb = std::move(ids);
  return {};
}

Value write_usb(const DeviceModel& device) {
  std::vector<Value> ids;
  for (const model::UsbId& id : device.usb)
    ids.push_back(Value::of(device::usb_ids(id.vendor, id.product)));
  return Value::array(std::move(ids));
}

std::vector<Key<DeviceModel>> make_device_keys() {
  using Device = DeviceModel;
  std::vector<Key<Device>> keys;
  keys.push_back(name_key<Device>(
      "name", [](auto& d) -> auto& { return d.name; }));
  keys.push_back(name_key<Device>(
      "model", [](auto& d) -> auto& { return d.model; }));
  for (Key<Device>& key : geometry_keys()) keys.push_back(std::move(key));
  keys.push_back({"coil_matrix", read_matrix, write_matrix});
  keys.push_back({"r25_ohm",
                  [](Device& d, const Value& v) {
                    return read_three(v, 0.05, 10.0, d.coils.r25_ohm,
                                      "three resistances, 0.05 to 10");
                  },
                  [](const Device& d) {
                    return three(d.coils.r25_ohm[0], d.coils.r25_ohm[1], d.coils.r25_ohm[2]);
                  }});
  const auto number = [&](const char* path, double min, double max, auto get) {
    keys.push_back(number_key<Device>(path, min, max, get));
  };
  number(
      "inductance_h", 1e-5, 0.1, [](auto& d) -> auto& { return d.coils.inductance_h; });
  number(
      "supply_v", 5.0, 24.0, [](auto& d) -> auto& { return d.coils.supply_v; });
  number(
      "force_slope_n_a", 0.001, 0.1, [](auto& d) -> auto& { return d.force_slope_n_a; });
  keys.push_back(windings_key(
      "thermal.winding_j_k", 1, 10000, [](auto& d) -> auto& { return d.thermal.winding_j_k; }));
  number(
      "thermal.core_j_k", 1, 10000, [](auto& d) -> auto& { return d.thermal.core_j_k; });
  keys.push_back(windings_key(
      "thermal.winding_to_core_k_w", 0.01, 100,
      [](auto& d) -> auto& { return d.thermal.winding_to_core_k_w; }));
  number(
      "thermal.core_to_room_fan_k_w", 0.01, 100,
      [](auto& d) -> auto& { return d.thermal.core_to_ambient_fan_k_w; });
  number(
      "thermal.core_to_room_still_k_w", 0.01, 100,
      [](auto& d) -> auto& { return d.thermal.core_to_ambient_still_k_w; });
  keys.push_back(integer_key<Device>(
      "thermal.sensor_winding", 0, 2, [](auto& d) -> auto& { return d.thermal.sensor_winding; }));
  number(
      "thermal.sensor_lag_s", model::kMinSensorLagS, 10,
      [](auto& d) -> auto& { return d.thermal.sensor_lag_s; });
  number(
      "thermal.fan_rpm", 300, 30000, [](auto& d) -> auto& { return d.thermal.fan_full_rpm; });
  constexpr model::ThermalUncertainty kMin = model::kMinUncertainty;
  constexpr model::ThermalUncertainty kMax = model::kMaxUncertainty;
  number(
      "uncertainty.thermal", kMin.thermal, kMax.thermal,
      [](auto& d) -> auto& { return d.uncertainty.thermal; });
  number(
      "uncertainty.resistance", kMin.resistance, kMax.resistance,
      [](auto& d) -> auto& { return d.uncertainty.resistance; });
  number(
      "uncertainty.thermistor_k", kMin.thermistor_k, kMax.thermistor_k,
      [](auto& d) -> auto& { return d.uncertainty.thermistor_k; });
  for (const LimitField& field : kLimitFields) {
    const auto member = field.member;
    keys.push_back(number_key<Device>(
        "limits." + std::string(field.name), field.min,
        field.max, [member](auto& d) -> auto& { return d.limits.*member; }));
  }
  keys.push_back({"usb", read_usb, write_usb});
  keys.push_back(serial_key<Device>(
      "usb_serial", [](auto& d) -> auto& { return d.usb_serial; }));
  return keys;
}

// The estimate would oscillate or diverge with nodes too light for the integration step.
void check_thermal(const model::ThermalModel& thermal, const Origins& origins,
                   const std::string& file, FileErrors& errors) {
  const model::NodeTimeConstants time = model::node_time_constants(thermal);
  const auto check = [&](const char* key, const std::string& what, double seconds) {
    if (seconds >= model::kMinTimeConstantS) return;
    errors.push_back(error_at(
        origins, key,
        what + " must be at least " + describe(Value::of(model::kMinTimeConstantS)) + " s, not " +
            describe(Value::of(seconds)) + ": too fast for the thermal estimate",
        file));
  };
  check("thermal.winding_j_k", "times winding_to_core_k_w", time.winding_s);
  check("thermal.core_j_k", "over all conductances of the core", time.core_s);
}

}  // namespace

const std::vector<Key<DeviceModel>>& device_keys() {
  static const std::vector<Key<DeviceModel>> keys = make_device_keys();
  return keys;
}

DeviceModel read_device(const Value& root, const std::string& file, const KnownGeometries& possible,
                        FileErrors& errors) {
  DeviceModel device;
  Origins origins;
  const std::size_t before = errors.size();
  read_keys(root, file, device_keys(), device, origins, errors);
  // Invalid single values are already reported; combinations are checked only without them.
  if (errors.size() == before) {
    check_order(device.limits, origins, file, errors);
    check_thermal(device.thermal, origins, file, errors);
    check_geometry(device.geometry, possible, origins, file, errors);
  }
  return device;
}

std::string print_device(const DeviceModel& device) {
  return to_json(write_keys(device_keys(), device));
}

}  // namespace hedgehog::config
