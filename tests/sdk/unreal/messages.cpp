// SPDX-License-Identifier: MIT
// Events and status as the daemon sends them, read into the plugin's structures. Exit: 1 one
// differs.
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>

#include "clients/unreal/Source/HedgehogHaptics/Private/core/json.h"
#include "clients/unreal/Source/HedgehogHaptics/Private/hedgehog_message_json.h"

namespace {

using hedgehog::unreal::Json;

int failures = 0;

void check(bool holds, const char* what) {
  if (holds) return;
  std::printf("not as sent: %s\n", what);
  ++failures;
}
#define CHECK(condition) check(condition, #condition)

template <class TMessage>
TMessage read(const char* text) {
  TMessage message;
  const std::optional<Json> json = Json::parse(text);
  check(json.has_value(), text);
  if (json) Read(*json, message);
  return message;
}

std::string text(const FString& value) { return stub_utf8(*value); }
bool near(double a, double b) { return std::abs(a - b) < 1e-6; }
bool near(const FVector& a, double x, double y, double z) {
  return near(a.X, x) && near(a.Y, y) && near(a.Z, z);
}

void check_events() {
  const auto ended = read<FHedgehogEvent>(
      R"({"type":"effect_ended","time_ns":91182734000123,"effect":4294967295,"slot":null,"seq":7,
          "reason":"completed","onset_ns":1,"offset_ns":null,"delivered":{"min":0.5,"mean":0.75}})");
  CHECK(ended.Type == EHedgehogEventType::EffectEnded);
  CHECK(text(ended.TypeName) == "effect_ended");
  CHECK(ended.TimeNs == 91182734000123);
  CHECK(ended.bHasEffect && ended.Effect == 4294967295);
  CHECK(ended.Slot.IsEmpty());
  CHECK(ended.bHasSeq && ended.Seq == 7);
  CHECK(text(ended.Reason) == "completed");
  CHECK(ended.bHasOnsetNs && ended.OnsetNs == 1);
  CHECK(!ended.bHasOffsetNs && ended.OffsetNs == 0);
  CHECK(ended.bHasDelivered && near(ended.Delivered.Min, 0.5) && near(ended.Delivered.Mean, 0.75));
  CHECK(!ended.bHasLimitA && !ended.bHasDisagreement);
  CHECK(text(ended.Json).find("\"seq\":7") != std::string::npos);

  const auto tripped = read<FHedgehogEvent>(
      R"({"type":"state_changed","time_ns":1,"state":"tripped","temperature_c":81.5,
          "disagreement":{"coil":2,"between":["model","sensor"]}})");
  CHECK(tripped.Type == EHedgehogEventType::StateChanged);
  CHECK(text(tripped.State) == "tripped");
  CHECK(tripped.bHasTemperatureC && near(tripped.TemperatureC, 81.5));
  CHECK(tripped.bHasDisagreement && tripped.Disagreement.Coil == 2);
  CHECK(tripped.Disagreement.Between.Num() == 2);
  CHECK(text(tripped.Disagreement.Between[1]) == "sensor");
  CHECK(!tripped.bHasEffect);

  const auto newer = read<FHedgehogEvent>(R"({"type":"polished","time_ns":1,"shine":2})");
  CHECK(newer.Type == EHedgehogEventType::Other);
  CHECK(text(newer.TypeName) == "polished");
  CHECK(text(newer.Json).find("\"shine\":2") != std::string::npos);
}

void check_status() {
  const auto now = read<FHedgehogStatus>(
      R"({"device":"ball","simulated":true,"derating":true,"headroom_s":null,"burst_s":22.5,
          "temperature_c":{"sensor":null,"model":31.5,"coils":[30,31,32],"age_ms":3},
          "field":[0,1,0],"pin":34,"fan":{"speed_rpm":null,"duty":0.25,"cooling":true},
          "orientation":{"quaternion":{"w":0.8,"x":0.1,"y":0.2,"z":0.6},"up":[0.5,0.25,-1],
                         "rate_deg_s":[1,2,3],"age_ms":4},
          "effects":[{"effect":9,"slot":"engine","method":"effect.vibrate","playing":true},
                     {"effect":10,"slot":null,"method":"effect.pulse","playing":false}],
          "loop":{"rate_hz":1000,"ticks":5,"skipped":0,"lateness_us":{"p50":1,"p99":2,"max":3}},
          "last_trip":{"reason":"over_temperature","time_ns":1,"temperature_c":null,
                       "current_a":15,"disagreement":{"coil":1,"between":[]}},
          "pins":{"force_n":[0.5,1.5],"extension_mm":[2]}})");
  CHECK(text(now.Device) == "ball" && now.bSimulated && now.bDerating);
  CHECK(!now.bHasHeadroomS && now.bHasBurstS && near(now.BurstS, 22.5));
  CHECK(!now.TemperatureC.bHasSensor && now.TemperatureC.bHasModel);
  CHECK(near(now.TemperatureC.Model, 31.5) && now.TemperatureC.AgeMs == 3);
  CHECK(now.TemperatureC.Coils.Num() == 3 && near(now.TemperatureC.Coils[2], 32));
  CHECK(now.TemperatureC.Sensors.Num() == 0);
  CHECK(now.bHasPin && now.Pin == 34);
  CHECK(!now.Fan.bHasSpeedRpm && near(now.Fan.Duty, 0.25));
  CHECK(now.Fan.bHasCooling && now.Fan.bCooling);
  CHECK(now.Effects.Num() == 2 && text(now.Effects[0].Slot) == "engine");
  CHECK(now.Effects[0].bPlaying && !now.Effects[1].bPlaying && now.Effects[1].Effect == 10);
  CHECK(near(now.Loop.RateHz, 1000) && near(now.Loop.LatenessUs.P99, 2));
  CHECK(now.bHasLastTrip && text(now.LastTrip.Reason) == "over_temperature");
  CHECK(!now.LastTrip.bHasTemperatureC && now.LastTrip.Disagreement.Coil == 1);
  CHECK(now.bHasPins && now.Pins.ForceN.Num() == 2 && near(now.Pins.ExtensionMm[0], 2));

  // The ball's left is Unreal's -y; a turn about it is one about Unreal's +y.
  CHECK(near(now.Field, 0, -1, 0));
  CHECK(now.bHasOrientation && near(now.Orientation.Up, 0.5, -0.25, -1));
  CHECK(near(now.Orientation.RateDegS, -1, 2, -3));
  const FQuat& turned = now.Orientation.Quaternion;
  CHECK(near(turned.W, 0.8) && near(turned.X, -0.1) && near(turned.Y, 0.2) && near(turned.Z, -0.6));
}

void check_what_was_not_sent() {
  const auto nothing = read<FHedgehogStatus>(R"({"time_ns":5,"orientation":null,"effects":[]})");
  CHECK(nothing.TimeNs == 5 && !nothing.bHasOrientation && !nothing.bHasPins);
  CHECK(nothing.State.IsEmpty() && nothing.Effects.Num() == 0);
  CHECK(near(nothing.Orientation.Quaternion.W, 1) && near(nothing.Field, 0, 0, 0));
}

}  // namespace

int main() {
  check_events();
  check_status();
  check_what_was_not_sent();
  if (failures == 0) std::puts("messages: ok");
  return failures == 0 ? 0 : 1;
}
