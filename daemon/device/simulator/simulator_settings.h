// SPDX-License-Identifier: MIT
// What a tester may change in the simulated world while it runs (`sim.set`): the room, and faults
// of the hardware. The orientation of the simulated ball does not pass here; it goes to
// control/mailbox.h like that of any sensor.
#pragma once

#include <cstdint>

#include "daemon/device/simulator/simulator_error.h"

namespace hedgehog::device {

/// Faults that the simulated board can show; bits of SimulatorSettings::faults. Wire names: the
/// enumerators in snake_case without the kSim.
enum SimFault : std::uint16_t {
  kSimSensorOpen = 1u << 0,
  kSimSensorShort = 1u << 1,
  kSimSensorFrozen = 1u << 2,  // keeps its last value
  kSimSensorJump = 1u << 3,    // +15 K at once
  kSimSensorStale = 1u << 4,   // telemetry carries on, the sensor field is marked not converted
  kSimSensorOffset = 1u << 5,  // drifts away by -0.5 K/s (a thermistor that comes loose)
  kSimStuckBridge = 1u << 6,   // winding `coil` is driven at 10 % whatever is commanded, until the
                               // supply switch opens
  kSimBridgeFault = 1u << 7,   // FLT line of winding `coil`
  kSimOpenWinding = 1u << 8,   // winding `coil` carries nothing
  kSimFanStopped = 1u << 9,
  kSimSilent = 1u << 10,        // the board answers no more (cable pulled, as seen from the host)
  kSimCurrentSense = 1u << 11,  // measured current of `coil` reads half
  kSimSupplyLow = 1u << 12,     // supply falls to 5 V
};

/// Trivially copyable.
struct SimulatorSettings {
  double ambient_c = 25.0;
  std::uint16_t faults = 0;
  /// Which winding the faults of one winding touch, 0..2.
  std::uint8_t coil = 0;
  SimulatorErrorList errors;
  friend constexpr bool operator==(const SimulatorSettings&,
                                   const SimulatorSettings&) noexcept = default;
};

}  // namespace hedgehog::device
