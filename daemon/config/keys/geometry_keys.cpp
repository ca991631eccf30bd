// SPDX-License-Identifier: MIT
#include "daemon/config/keys/geometry_keys.h"

#include <algorithm>
#include <utility>

namespace hedgehog::config {

using namespace keys;

namespace {

using model::DeviceModel;

/// GP(8,0) has 642 pins and 1280 shields.
constexpr double kMaxSite = 1279;

/// Diameter and height of a cylinder, mm.
Reason read_magnet(const Value& value, model::CylinderMagnet& out) {
  const std::string shape = "diameter and height in mm, such as [8, 10]";
  if (value.kind != Value::Kind::kArray || value.elements.size() != 2) return must_be(shape, value);
  Reason reason = read_number(value.elements[0], 0.1, 100.0, out.diameter_mm);
  if (reason.empty()) reason = read_number(value.elements[1], 0.1, 100.0, out.height_mm);
  return reason;
}

template <class Get>
Key<DeviceModel> magnet_key(std::string path, Get get) {
  return {std::move(path), [=](DeviceModel& d, const Value& v) { return read_magnet(v, get(d)); },
          [=](const DeviceModel& d) {
            return Value::array({Value::of(get(d).diameter_mm), Value::of(get(d).height_mm)});
          }};
}

/// A list of pin or shield ids.
template <class Get>
Key<DeviceModel> sites_key(std::string path, Get get) {
  return {std::move(path),
          [=](DeviceModel& d, const Value& v) -> Reason {
            if (v.kind != Value::Kind::kArray) return must_be("a list of numbers", v);
            std::vector<int> ids;
            for (const Value& element : v.elements) {
              double id = 0.0;
              if (Reason reason = read_integer(element, 0, kMaxSite, id); !reason.empty())
                return reason;
              if (std::find(ids.begin(), ids.end(), static_cast<int>(id)) != ids.end())
                return "names " + describe(element) + " twice";
              ids.push_back(static_cast<int>(id));
            }
            get(d) = std::move(ids);
            return {};
          },
          [=](const DeviceModel& d) {
            std::vector<Value> ids;
            for (const int id : get(d)) ids.push_back(Value::of(double{1.0} * id));
            return Value::array(std::move(ids));
          }};
}

/// The key to report for an error; of several candidates the first one that is set.
std::string key_of(model::GeometryPart part, const Origins& origins) {
  using model::GeometryPart;
  std::vector<std::string> keys;
  switch (part) {
    case GeometryPart::kArrangement:
      break;
    case GeometryPart::kRemovedPins:
      keys = {"removed_pins"};
      break;
    case GeometryPart::kRemovedShields:
      keys = {"removed_shields"};
      break;
    case GeometryPart::kFrontPin:
      keys = {"front_pin"};
      break;
    case GeometryPart::kPinSizes:
      keys = {"pin_magnet_mm", "sphere_mm"};
      break;
    case GeometryPart::kAllSizes:
      keys = {"shield_magnet_mm", "pin_magnet_mm", "sphere_mm"};
      break;
  }
  const auto written = std::find_if(keys.begin(), keys.end(), [&](const std::string& key) {
    return origins.find(key) != origins.end();
  });
  return written != keys.end() ? *written : "arrangement";
}

}  // namespace

std::vector<Key<DeviceModel>> geometry_keys() {
  using Device = DeviceModel;
  std::vector<Key<Device>> keys;
  keys.push_back({"arrangement",
                  [](Device& d, const Value& v) -> Reason {
                    if (v.kind != Value::Kind::kText) return must_be("the name of an array", v);
                    d.geometry.arrangement = v.text;
                    return {};
                  },
                  [](const Device& d) { return Value::of(d.geometry.arrangement); }});
  keys.push_back(sites_key(
      "removed_pins", [](auto& d) -> auto& { return d.geometry.removed_pins; }));
  keys.push_back(sites_key(
      "removed_shields", [](auto& d) -> auto& { return d.geometry.removed_shields; }));
  keys.push_back(integer_key<Device>(
      "front_pin", 0, kMaxSite, [](auto& d) -> auto& { return d.geometry.front_pin; }));
  keys.push_back(magnet_key(
      "pin_magnet_mm", [](auto& d) -> auto& { return d.geometry.sizes.pin; }));
  keys.push_back(magnet_key(
      "shield_magnet_mm", [](auto& d) -> auto& { return d.geometry.sizes.shield; }));
  keys.push_back({"remanence_t",
                  [](Device& d, const Value& v) {
                    Reason reason = read_number(v, 0.1, 2.0, d.geometry.sizes.pin.remanence_t);
                    d.geometry.sizes.shield.remanence_t = d.geometry.sizes.pin.remanence_t;
                    return reason;
                  },
                  [](const Device& d) { return Value::of(d.geometry.sizes.pin.remanence_t); }});
  keys.push_back(number_key<Device>(
      "sphere_mm", 5, 500, [](auto& d) -> auto& { return d.geometry.sizes.sphere_radius_mm; }));
  return keys;
}

void check_geometry(const model::BallGeometry& geometry, const KnownGeometries& possible,
                    const Origins& origins, const std::string& file, FileErrors& errors) {
  if (geometry == model::BallGeometry{}) return;
  if (std::find(possible.begin(), possible.end(), geometry) != possible.end()) return;
  const auto arrangement = model::arrangement_of(geometry);
  if (!arrangement.has_error()) return;
  const model::MagnetError& error = arrangement.error();
  errors.push_back(error_at(origins, key_of(error.part, origins), error.message, file));
}

}  // namespace hedgehog::config
