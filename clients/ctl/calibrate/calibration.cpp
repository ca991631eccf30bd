// SPDX-License-Identifier: MIT
#include "clients/ctl/calibrate/calibration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "model/coils.h"
#include "model/thermal/thermal_uncertainty.h"
#include "protocol/wire/json.h"

namespace hedgehog::client {
namespace {

struct Side {
  std::string_view name;
  int axis;
  double sign;
};
constexpr std::array<Side, 6> kSides{{{"front", 0, 1.0},
                                      {"back", 0, -1.0},
                                      {"left", 1, 1.0},
                                      {"right", 1, -1.0},
                                      {"up", 2, 1.0},
                                      {"down", 2, -1.0}}};

/// Above the noise of a current sensor.
constexpr double kFlowsA = 0.03;
/// Ranges of a device file.
constexpr double kMinOhm = 0.05;
constexpr double kMaxOhm = 10.0;
constexpr double kMaxLagS = 10.0;

const Side* side_named(std::string_view name) {
  const auto found = std::find_if(kSides.begin(), kSides.end(),
                                  [&](const Side& side) { return side.name == name; });
  return found == kSides.end() ? nullptr : &*found;
}

std::string three(const std::array<double, 3>& values) {
  return fmt::format("[{:.5g}, {:.5g}, {:.5g}]", values[0], values[1], values[2]);
}

std::string matrix_text(const std::array<model::Vec3, 3>& rows) {
  std::string text = "[";
  for (std::size_t i = 0; i < 3; ++i)
    text += (i == 0 ? "" : ", ") + three({rows[i].x, rows[i].y, rows[i].z});
  return text + "]";
}

}  // namespace

std::string winding_problem(int coil, const std::array<double, 3>& forth_a,
                            const std::array<double, 3>& back_a,
                            std::optional<double> resistance_ohm) {
  std::array<double, 3> carried_a{};
  for (std::size_t i = 0; i < 3; ++i) carried_a[i] = std::abs(forth_a[i] - back_a[i]) / 2.0;
  const auto most = std::max_element(carried_a.begin(), carried_a.end()) - carried_a.begin();
  std::ostringstream text;
  text << "winding "
       << "xyz"[coil] << ": ";
  if (most != coil && carried_a[static_cast<std::size_t>(most)] > kFlowsA) {
    text << "when it is driven the current is measured in "
         << "xyz"[most] << "; compare the plugs of the coils with those of the current sensors";
  } else if (!resistance_ohm) {
    text << "no current flows; check its plug";
  } else if (*resistance_ohm < 0.0) {
    text << "its current sensor reads the other way round; turn it on the board, a device file "
            "cannot";
  } else if (*resistance_ohm < kMinOhm || *resistance_ohm > kMaxOhm) {
    text << fmt::format("{:.2f}", *resistance_ohm)
         << " ohm, and a device file takes 0.05 to 10; check its plug, and the winding for a short";
  } else {
    return {};
  }
  return text.str();
}

std::string side_meant(std::string_view answer) {
  constexpr std::string_view kSpace = " \t\r";
  const std::size_t from = answer.find_first_not_of(kSpace);
  if (from == std::string_view::npos) return {};
  std::string word(answer.substr(from, answer.find_last_not_of(kSpace) + 1 - from));
  for (char& c : word)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  // The first letters differ, so any prefix is unambiguous.
  const auto* found = std::find_if(kSides.begin(), kSides.end(),
                                   [&](const Side& side) { return side.name.starts_with(word); });
  return found == kSides.end() ? std::string() : std::string(found->name);
}

std::optional<std::size_t> same_axis(const PushedSides& pushed, std::size_t winding) {
  const Side* const own = side_named(pushed.side[winding]);
  for (std::size_t other = 0; own != nullptr && other < winding; ++other) {
    const Side* const side = side_named(pushed.side[other]);
    if (side != nullptr && side->axis == own->axis) return other;
  }
  return std::nullopt;
}

bool is_left_handed(const PushedSides& pushed) {
  const auto rows = coil_matrix(pushed);
  return rows && model::dot((*rows)[0], model::cross((*rows)[1], (*rows)[2])) < 0.0;
}

std::optional<PushedSides> read_pushed(const std::vector<std::string>& words) {
  PushedSides pushed;
  for (const std::string& word : words) {
    const bool shaped = word.size() > 2 && word[0] >= 'x' && word[0] <= 'z' && word[1] == '=';
    if (!shaped || side_named(word.substr(2)) == nullptr) return std::nullopt;
    pushed.side[static_cast<std::size_t>(word[0] - 'x')] = word.substr(2);
  }
  if (!words.empty() && !coil_matrix(pushed)) return std::nullopt;
  return pushed;
}

std::optional<std::array<model::Vec3, 3>> coil_matrix(const PushedSides& pushed) {
  std::array<model::Vec3, 3> rows{};
  for (std::size_t winding = 0; winding < 3; ++winding) {
    const Side* side = side_named(pushed.side[winding]);
    if (side == nullptr || same_axis(pushed, winding)) return std::nullopt;
    rows[winding][side->axis] = side->sign;
  }
  return rows;
}

namespace {

std::string heat_comment(const std::optional<model::ThermalFound>& found) {
  if (!found) return "  // Not measured: as it was.\n";
  const auto& d = found->deviation;
  const auto each = [](const std::array<double, 3>& shares) {
    return fmt::format("{:.1f}, {:.1f}, {:.1f}", 100.0 * shares[0], 100.0 * shares[1],
                       100.0 * shares[2]);
  };
  return fmt::format(
      "  // By heating and cooling. Standard deviations in %: windings {}; to the core {};\n"
      "  // core {:.1f}; to the room with fan {:.1f}, without {:.1f}, which is not in "
      "\"uncertainty\": a warm ball has its fan on.\n",
      each(d.winding_j_k), each(d.winding_to_core_k_w), 100.0 * d.core_j_k,
      100.0 * d.core_to_ambient_fan_k_w, 100.0 * d.core_to_ambient_still_k_w);
}

std::string heat_text(const Calibration& measured, const protocol::Description& before) {
  model::ThermalModel t = measured.thermal ? measured.thermal->thermal : before.thermal;
  t.sensor_lag_s = std::min(t.sensor_lag_s, kMaxLagS);
  const double uncertainty =
      measured.thermal ? measured.thermal->uncertainty : before.uncertainty.thermal;
  return heat_comment(measured.thermal) +
         fmt::format(R"(  "thermal": {{
    "winding_j_k": {},
    "core_j_k": {:.5g},
    "winding_to_core_k_w": {},
    "core_to_room_fan_k_w": {:.5g},
    "core_to_room_still_k_w": {:.5g},
    "sensor_winding": {},
    "sensor_lag_s": {:.5g}
  }},
  "uncertainty": {{
    "thermal": {:.3f},
    "resistance": {:.3f},
    "thermistor_k": {:.5g}
  }},
)",
                     three(t.winding_j_k), t.core_j_k, three(t.winding_to_core_k_w),
                     t.core_to_ambient_fan_k_w, t.core_to_ambient_still_k_w, t.sensor_winding,
                     t.sensor_lag_s, uncertainty, resistance_uncertainty(measured),
                     before.uncertainty.thermistor_k);
}

}  // namespace

double resistance_uncertainty(const Calibration& measured) {
  const double by_heat = model::kCopperPerKelvin * measured.apart_k;
  const double share = measured.resistance_share + (measured.unrest.empty() ? 0.0 : by_heat);
  return std::clamp(share, model::kMinUncertainty.resistance, model::kMaxUncertainty.resistance);
}

std::string device_file(const Calibration& measured, const protocol::Description& before) {
  const auto& l = before.limits;
  const auto matrix = coil_matrix(measured.pushed);
  const double inductance_h =
      (measured.inductance_h[0] + measured.inductance_h[1] + measured.inductance_h[2]) / 3.0;
  std::string text =
      fmt::format(
          "// Measured by hedgehogctl calibrate with {:.5g} A at {:.1f} degrees "
          "Celsius, supply {:.2f} V.\n",
          measured.current_a, measured.sensor_c, measured.supply_v) +
      (measured.unrest.empty() ? "" : "// Forced: " + measured.unrest + ".\n") +
      "// The protocol does not report model, removed_pins, removed_shields, front_pin, "
      "pin_magnet_mm,\n"
      "// shield_magnet_mm, remanence_t, sphere_mm, usb and usb_serial: copy them "
      "from the file before,\n"
      "// where they differ from a hedgehog-86.\n"
      "{\n"
      "  \"name\": \"" +
      measured.name + "\",\n";
  if (!before.arrangement.empty()) {
    text += "  \"arrangement\": ";
    protocol::append_string(text, before.arrangement);
    text += ",\n";
  }
  text +=
      matrix
          ? "  // By the sides that a person felt; how strong each winding is was not measured.\n"
          : "  // Not measured: as it was.\n";
  text += "  \"coil_matrix\": " +
          matrix_text(matrix.value_or(std::array<model::Vec3, 3>{
              before.coils.matrix[0], before.coils.matrix[1], before.coils.matrix[2]})) +
          ",\n";
  text += fmt::format(R"(  "r25_ohm": {},
  // Of the windings: {}.
  "inductance_h": {:.5g},
  "supply_v": {:.5g},
  "force_slope_n_a": {:.5g},
)",
                      three(measured.r25_ohm), three(measured.inductance_h), inductance_h,
                      before.coils.supply_v, before.calibration.force_n_per_a);
  text += heat_text(measured, before);
  return text + fmt::format(R"(  "limits": {{
    "current_a": {:.5g},
    "continuous_a": {:.5g},
    "felt_a": {:.5g},
    "derate_from_c": {:.5g},
    "sustain_c": {:.5g},
    "zero_c": {:.5g},
    "trip_c": {:.5g},
    "rearm_c": {:.5g}
  }}
}}
)",
                            l.current_a, l.continuous_a, l.felt_a, l.derate_from_c, l.sustain_c,
                            l.zero_c, l.trip_c, l.rearm_c);
}

}  // namespace hedgehog::client
