// SPDX-License-Identifier: MIT
// Settings of the simulator that can be changed while it runs (`sim.set`): the ambient temperature
// and hardware faults. The orientation of the simulated ball is not part of them; like that of any
// sensor it is sent through control/mailbox.h.
#pragma once

#include <cstdint>

#include "daemon/device/simulator/simulator_error.h"

namespace hedgehog::device {

/// Faults of the simulated board; bits of SimulatorSettings::faults. Wire names: the enumerators in
/// snake_case without the kSim.
enum SimFault : std::uint16_t {
  kSimSensorOpen = 1u << 0,
  kSimSensorShort = 1u << 1,
  kSimSensorFrozen = 1u << 2,  // keeps its last value
  kSimSensorJump = 1u << 3,    // +15 K at once
  kSimSensorStale = 1u << 4,   // telemetry continues, the sensor field is marked as not converted
  kSimSensorOffset = 1u << 5,  // drifts by -0.5 K/s (a thermistor that comes loose)
  kSimStuckBridge = 1u << 6,   // winding `coil` is driven at 10 % until the supply switch opens
  kSimBridgeFault = 1u << 7,   // FLT line of winding `coil`
  kSimOpenWinding = 1u << 8,   // winding `coil` carries no current
  kSimFanStopped = 1u << 9,
  kSimSilent = 1u << 10,  // the board stops responding (cable unplugged, as seen from the host)
  kSimCurrentSense = 1u << 11,  // measured current of `coil` is halved
  kSimSupplyLow = 1u << 12,     // supply falls to 5 V
};

/// Trivially copyable.
struct SimulatorSettings {
  double ambient_c = 25.0;
  std::uint16_t faults = 0;
  std::uint8_t coil = 0;  // affected by faults of one winding, 0..2
  SimulatorErrorList errors;
  friend constexpr bool operator==(const SimulatorSettings&,
                                   const SimulatorSettings&) noexcept = default;
};

}  // namespace hedgehog::device
