// SPDX-License-Identifier: MIT
// sim.*
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "protocol/method_info.h"
#include "protocol/methods/orientation.h"
#include "protocol/values/sim_error.h"
#include "protocol/wire/fields.h"

namespace hedgehog::protocol {

/// Present state of the simulated plant.
struct SimResult {
  static constexpr std::string_view kSchema = "SimulatedWorld";
  double ambient_c = 25.0;
  std::vector<std::string> faults{};
  std::int64_t coil = 0;
  std::vector<SimError> errors{};

  void describe(Fields& f) {
    f.required("ambient_c", ambient_c, decimals(2));
    f.required("faults", faults);
    f.required("coil", coil);
    f.required("errors", errors, {.items = kMaxSimErrors});
  }
  friend bool operator==(const SimResult&, const SimResult&) = default;
};

/// Replaces all faults of the simulated board; empty `faults` clears them.
struct SimFault {
  std::vector<std::string> faults{};  // wire names of device::SimFault; checked by the server
  std::int64_t coil = 0;              // the winding affected by single-winding faults

  void describe(Fields& f) {
    f.defaulted("faults", faults);
    f.defaulted("coil", coil, {.min = 0, .max = 2});
  }
  friend bool operator==(const SimFault&, const SimFault&) = default;
};

/// Omitted fields are unchanged.
struct SimSet {
  static constexpr MethodInfo kMethod{
      "sim.set",
      Role::kOperate,
      "Sets orientation, ambient temperature and faults of the simulation.",
      {ErrorCode::kUnsupported}};
  using Result = SimResult;

  std::optional<model::Quaternion> orientation{};
  std::optional<double> ambient_c{};
  std::optional<SimFault> fault{};
  std::optional<std::vector<SimError>> errors{};  // replaces all

  void describe(Fields& f) {
    f.optional("orientation", orientation);
    f.optional("ambient_c", ambient_c, {.min = -20, .max = 60});
    f.optional("fault", fault);
    f.optional("errors", errors, {.items = kMaxSimErrors});
    if (f.checks() && orientation) normalise(f, "orientation", *orientation);
  }
  friend bool operator==(const SimSet&, const SimSet&) = default;
};

/// True state of the simulated ball, independent of measurements.
struct SimTruthResult {
  static constexpr std::string_view kSchema = "SimulatedTruth";
  std::vector<double> coils_c{};  // each winding
  double core_c = 0.0;
  double skin_c = 0.0;
  std::vector<double> current_a{};
  double ambient_c = 0.0;

  void describe(Fields& f) {
    f.required("coils_c", coils_c, decimals(3));
    f.required("core_c", core_c, decimals(3));
    f.required("skin_c", skin_c, decimals(3));
    f.required("current_a", current_a, decimals(3));
    f.required("ambient_c", ambient_c, decimals(2));
  }
  friend bool operator==(const SimTruthResult&, const SimTruthResult&) = default;
};

struct SimTruth {
  static constexpr MethodInfo kMethod{
      "sim.truth", Role::kOperate, "True state of the simulated ball.", {ErrorCode::kUnsupported}};
  using Result = SimTruthResult;
  friend bool operator==(const SimTruth&, const SimTruth&) = default;
};

using SimMethods = TypeList<SimSet, SimTruth>;

}  // namespace hedgehog::protocol
