// SPDX-License-Identifier: MIT
// What a board reports of its rules (../board-rules.md), with the values of the wire.
#pragma once

#include <stdint.h>

namespace hedgehog::board {

/// Bits; latched until the board is armed.
enum Fault : uint16_t {
  kDeadMan = 1u << 0,            // no valid set-point for 100 ms
  kOverCurrent = 1u << 1,        // |I| > 16.5 A for 50 ms
  kOverHeat = 1u << 2,           // thermistor above the board's own limit, 75 C
  kHeatBudget = 1u << 3,         // the board's own I^2 t
  kBridge = 1u << 4,             // a bridge signals FLT
  kSensorOpen = 1u << 5,         // thermistor line at the rail
  kSensorShort = 1u << 6,        // thermistor line at ground
  kStuckBridge = 1u << 7,        // current for 20 ms after the safe state: supply switch opened
  kSupply = 1u << 8,             // supply voltage out of range (reference board: 6.5..18 V)
  kUnexpectedCurrent = 1u << 9,  // more current than the duties can drive
  kCurrentSense = 1u << 10,      // a driven winding's current is not measured
};

enum class Mode : uint8_t {
  kSafe = 0,     // never armed since power-up
  kReady = 1,    // armed, bridges asleep
  kDriving = 2,  // armed, bridges awake
  kLatched = 3,  // after a fault: bridges asleep until armed
};

}  // namespace hedgehog::board
