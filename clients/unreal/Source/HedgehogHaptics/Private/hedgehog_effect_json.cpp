// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
#include "hedgehog_effect_json.h"

#include <cmath>

using hedgehog::unreal::Json;

namespace {

/// 0.1f as 0.1, not as 0.100000001490116.
double Decimal(float Value) { return std::round(static_cast<double>(Value) * 1e6) / 1e6; }

}  // namespace

Json HedgehogToJson(const FHedgehogEffect& Effect) {
  Json Given = Json::object();
  if (Effect.Frame != EHedgehogFrame::Default) {
    static const char* const Words[] = {"device", "world", "coil"};
    Given.set("frame", Words[static_cast<int>(Effect.Frame) - 1]);
  }
  if (Effect.Level >= 0) Given.set("level", Decimal(Effect.Level));
  if (Effect.CurrentA >= 0) Given.set("current_a", Decimal(Effect.CurrentA));
  if (Effect.ForceN >= 0) Given.set("force_n", Decimal(Effect.ForceN));
  if (Effect.Gain >= 0) Given.set("gain", Decimal(Effect.Gain));
  if (Effect.StartAtNs >= 0) Given.set("start_at_ns", static_cast<std::int64_t>(Effect.StartAtNs));
  if (Effect.DelayMs >= 0) Given.set("delay_ms", Decimal(Effect.DelayMs));
  if (Effect.AttackMs >= 0) Given.set("attack_ms", Decimal(Effect.AttackMs));
  if (Effect.FadeMs >= 0) Given.set("fade_ms", Decimal(Effect.FadeMs));
  if (Effect.AttackLevel >= 0) Given.set("attack_level", Decimal(Effect.AttackLevel));
  if (Effect.FadeLevel >= 0) Given.set("fade_level", Decimal(Effect.FadeLevel));
  if (Effect.Waveform != EHedgehogWaveform::Default) {
    static const char* const Words[] = {"constant", "sine", "square", "triangle", "sawtooth", "noise"};
    Given.set("waveform", Words[static_cast<int>(Effect.Waveform) - 1]);
  }
  if (Effect.FrequencyHz >= 0) Given.set("frequency_hz", Decimal(Effect.FrequencyHz));
  if (Effect.OnFraction >= 0) Given.set("on_fraction", Decimal(Effect.OnFraction));
  if (Effect.DurationMs >= 0) Given.set("duration_ms", Decimal(Effect.DurationMs));
  if (Effect.LeaseMs >= 0) Given.set("lease_ms", Decimal(Effect.LeaseMs));
  if (Effect.OnClose != EHedgehogOnClose::Default) {
    static const char* const Words[] = {"stop", "finish"};
    Given.set("on_close", Words[static_cast<int>(Effect.OnClose) - 1]);
  }
  if (!Effect.Slot.IsEmpty()) Given.set("slot", std::string(TCHAR_TO_UTF8(*Effect.Slot)));
  if (Effect.Priority >= 0) Given.set("priority", static_cast<std::int64_t>(Effect.Priority));
  if (Effect.IfLimited != EHedgehogIfLimited::Default) {
    static const char* const Words[] = {"reduce", "refuse"};
    Given.set("if_limited", Words[static_cast<int>(Effect.IfLimited) - 1]);
  }
  return Given;
}

Json HedgehogToJson(const FHedgehogCircle& Effect) {
  Json Given = HedgehogToJson(static_cast<const FHedgehogEffect&>(Effect));
  if (Effect.RingDeg >= 0) Given.set("ring_deg", Decimal(Effect.RingDeg));
  if (Effect.SpeedPinsS >= 0) Given.set("speed_pins_s", Decimal(Effect.SpeedPinsS));
  if (Effect.Sense != EHedgehogSense::Default) {
    static const char* const Words[] = {"ccw", "cw"};
    Given.set("sense", Words[static_cast<int>(Effect.Sense) - 1]);
  }
  if (Effect.Stepping != EHedgehogStepping::Default) {
    static const char* const Words[] = {"pin", "smooth"};
    Given.set("stepping", Words[static_cast<int>(Effect.Stepping) - 1]);
  }
  return Given;
}

Json HedgehogToJson(const FHedgehogPlay& Effect) {
  Json Given = HedgehogToJson(static_cast<const FHedgehogEffect&>(Effect));
  if (Effect.Rate >= 0) Given.set("rate", Decimal(Effect.Rate));
  if (Effect.bLoop) Given.set("loop", true);
  return Given;
}
