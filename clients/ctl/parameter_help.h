// SPDX-License-Identifier: MIT
// The parameters of the effects as the playing verbs' options name and explain them.
#pragma once

#include <array>

namespace hedgehog::client {

/// A parameter of the protocol as an option: `duration_ms` is `--duration-ms`.
struct ParameterHelp {
  const char* name;
  const char* help;
};

inline constexpr std::array kPlayParameters{
    ParameterHelp{"level", "strength, 0..1 of the ball's limit"},
    ParameterHelp{"current_a", "strength in ampere (5 for ever, 15 for about 22 s)"},
    ParameterHelp{"force_n", "strength in newton at the nearest pin"},
    ParameterHelp{"gain", "0..1"},
    ParameterHelp{"frame", "device, world, or coil"},
    ParameterHelp{"delay_ms", "waits first, 0..10000"},
    ParameterHelp{"attack_ms", "rises for so long"},
    ParameterHelp{"fade_ms", "falls for so long at the end"},
    ParameterHelp{"waveform", "constant, sine, square, triangle, sawtooth, noise"},
    ParameterHelp{"frequency_hz", "of the waveform, 0.5..250"},
    ParameterHelp{"on_fraction", "of a square wave, 0.05..0.95"},
    ParameterHelp{"priority", "0..7; the highest is felt alone (8, 9: operate)"},
    ParameterHelp{"if_limited", "reduce, or refuse when it is too warm"},
    ParameterHelp{"slot", "a name for it; the next one of that name replaces it"},
};
inline constexpr std::array kTimedParameters{
    ParameterHelp{"duration_ms", "ends by itself after, 1..10000"},
};
inline constexpr std::array kCircleParameters{
    ParameterHelp{"axis", "what it goes round: up, or any direction word"},
    ParameterHelp{"ring_deg", "angle from the axis, 0..180"},
    ParameterHelp{"speed_pins_s", "steps a second, 0.1..100"},
    ParameterHelp{"sense", "ccw or cw, seen from outside along the axis"},
    ParameterHelp{"stepping", "pin by pin, or smooth"},
};
inline constexpr std::array kPatternParameters{
    ParameterHelp{"rate", "so many times as fast, 0.1..10"},
};

}  // namespace hedgehog::client
