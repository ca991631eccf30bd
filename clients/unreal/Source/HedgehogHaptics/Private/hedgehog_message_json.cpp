// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
#include "hedgehog_message_json.h"

#include <cstdint>

#include "core/methods.h"

namespace hedgehog::unreal {

static void Read(const Json& Value, bool& Member) { Member = Value.truth(); }
static void Read(const Json& Value, int64& Member) { Member = static_cast<int64>(Value.number()); }
static void Read(const Json& Value, float& Member) { Member = static_cast<float>(Value.number()); }
static void Read(const Json& Value, FString& Member) { Member = FString(UTF8_TO_TCHAR(Value.text().c_str())); }

/// The ball's axes are x front, y left, z up: Unreal's, with y reversed.
static FVector ToDirection(const Json& Value) {
  if (Value.items().size() != 3) return FVector::ZeroVector;
  return FVector(Value.items()[0].number(), -Value.items()[1].number(), Value.items()[2].number());
}

/// A rotation changes its sense when an axis is reversed.
static FVector ToRate(const Json& Value) { return -ToDirection(Value); }

static void Read(const Json& Value, FQuat& Member) {
  if (!Value.is(Json::Kind::kObject)) return;
  Member = FQuat(-Value["x"].number(), Value["y"].number(), -Value["z"].number(), Value["w"].number());
}

static void Read(const Json& Value, EHedgehogEventType& Member) {
  std::uint8_t Number = 0;
  Member = EHedgehogEventType::Other;
  for (const char* Type : methods::kEvents) {
    ++Number;
    if (Value.text() == Type) Member = static_cast<EHedgehogEventType>(Number);
  }
}

static void Read(const Json& Value, FHedgehogEventDelivered& Message);
static void Read(const Json& Value, FHedgehogEventDisagreement& Message);
static void Read(const Json& Value, FHedgehogStatusTemperatureC& Message);
static void Read(const Json& Value, FHedgehogStatusFan& Message);
static void Read(const Json& Value, FHedgehogStatusOrientation& Message);
static void Read(const Json& Value, FHedgehogStatusEffect& Message);
static void Read(const Json& Value, FHedgehogStatusLoopLatenessUs& Message);
static void Read(const Json& Value, FHedgehogStatusLoop& Message);
static void Read(const Json& Value, FHedgehogStatusLink& Message);
static void Read(const Json& Value, FHedgehogStatusLastTrip& Message);
static void Read(const Json& Value, FHedgehogStatusPins& Message);

template <class T>
static void Read(const Json& Value, TArray<T>& Member) {
  for (const Json& One : Value.items()) {
    T Item{};
    Read(One, Item);
    Member.Add(Item);
  }
}

static void Read(const Json& Value, FHedgehogEventDelivered& Message) {
  Read(Value["min"], Message.Min);
  Read(Value["mean"], Message.Mean);
}

static void Read(const Json& Value, FHedgehogEventDisagreement& Message) {
  Read(Value["coil"], Message.Coil);
  Read(Value["between"], Message.Between);
}

void Read(const Json& Value, FHedgehogEvent& Message) {
  Read(Value["type"], Message.Type);
  Read(Value["type"], Message.TypeName);
  Read(Value["time_ns"], Message.TimeNs);
  Read(Value["state"], Message.State);
  Message.bHasEffect = !Value["effect"].is(Json::Kind::kNull);
  Read(Value["effect"], Message.Effect);
  Read(Value["slot"], Message.Slot);
  Message.bHasSeq = !Value["seq"].is(Json::Kind::kNull);
  Read(Value["seq"], Message.Seq);
  Read(Value["reason"], Message.Reason);
  Read(Value["remedy"], Message.Remedy);
  Message.bHasOnsetNs = !Value["onset_ns"].is(Json::Kind::kNull);
  Read(Value["onset_ns"], Message.OnsetNs);
  Message.bHasOffsetNs = !Value["offset_ns"].is(Json::Kind::kNull);
  Read(Value["offset_ns"], Message.OffsetNs);
  Message.bHasDelivered = !Value["delivered"].is(Json::Kind::kNull);
  Read(Value["delivered"], Message.Delivered);
  Message.bHasMaskedMs = !Value["masked_ms"].is(Json::Kind::kNull);
  Read(Value["masked_ms"], Message.MaskedMs);
  Message.bHasMixedMs = !Value["mixed_ms"].is(Json::Kind::kNull);
  Read(Value["mixed_ms"], Message.MixedMs);
  Message.bHasLimitA = !Value["limit_a"].is(Json::Kind::kNull);
  Read(Value["limit_a"], Message.LimitA);
  Message.bHasTemperatureC = !Value["temperature_c"].is(Json::Kind::kNull);
  Read(Value["temperature_c"], Message.TemperatureC);
  Message.bHasCurrentA = !Value["current_a"].is(Json::Kind::kNull);
  Read(Value["current_a"], Message.CurrentA);
  Message.bHasDisagreement = !Value["disagreement"].is(Json::Kind::kNull);
  Read(Value["disagreement"], Message.Disagreement);
  Read(Value["device"], Message.Device);
  Message.bHasSkipped = !Value["skipped"].is(Json::Kind::kNull);
  Read(Value["skipped"], Message.Skipped);
  Message.Json = FString(UTF8_TO_TCHAR(Value.to_text().c_str()));
}

static void Read(const Json& Value, FHedgehogStatusTemperatureC& Message) {
  Message.bHasSensor = !Value["sensor"].is(Json::Kind::kNull);
  Read(Value["sensor"], Message.Sensor);
  Message.bHasModel = !Value["model"].is(Json::Kind::kNull);
  Read(Value["model"], Message.Model);
  Read(Value["coils"], Message.Coils);
  Message.bHasUpper = !Value["upper"].is(Json::Kind::kNull);
  Read(Value["upper"], Message.Upper);
  Message.bHasCore = !Value["core"].is(Json::Kind::kNull);
  Read(Value["core"], Message.Core);
  Read(Value["sensors"], Message.Sensors);
  Message.bHasSkin = !Value["skin"].is(Json::Kind::kNull);
  Read(Value["skin"], Message.Skin);
  Message.bHasAgeMs = !Value["age_ms"].is(Json::Kind::kNull);
  Read(Value["age_ms"], Message.AgeMs);
  Message.bHasThermometer = !Value["thermometer"].is(Json::Kind::kNull);
  Read(Value["thermometer"], Message.Thermometer);
}

static void Read(const Json& Value, FHedgehogStatusFan& Message) {
  Message.bHasSpeedRpm = !Value["speed_rpm"].is(Json::Kind::kNull);
  Read(Value["speed_rpm"], Message.SpeedRpm);
  Read(Value["duty"], Message.Duty);
  Message.bHasCooling = !Value["cooling"].is(Json::Kind::kNull);
  Read(Value["cooling"], Message.bCooling);
}

static void Read(const Json& Value, FHedgehogStatusOrientation& Message) {
  Read(Value["quaternion"], Message.Quaternion);
  Message.Up = ToDirection(Value["up"]);
  Message.RateDegS = ToRate(Value["rate_deg_s"]);
  Read(Value["age_ms"], Message.AgeMs);
}

static void Read(const Json& Value, FHedgehogStatusEffect& Message) {
  Read(Value["effect"], Message.Effect);
  Read(Value["slot"], Message.Slot);
  Read(Value["method"], Message.Method);
  Read(Value["connection"], Message.Connection);
  Read(Value["client"], Message.Client);
  Read(Value["priority"], Message.Priority);
  Read(Value["playing"], Message.bPlaying);
  Read(Value["remaining_ms"], Message.RemainingMs);
  Read(Value["current_a"], Message.CurrentA);
}

static void Read(const Json& Value, FHedgehogStatusLoopLatenessUs& Message) {
  Read(Value["p50"], Message.P50);
  Read(Value["p99"], Message.P99);
  Read(Value["max"], Message.Max);
}

static void Read(const Json& Value, FHedgehogStatusLoop& Message) {
  Read(Value["rate_hz"], Message.RateHz);
  Read(Value["ticks"], Message.Ticks);
  Read(Value["skipped"], Message.Skipped);
  Read(Value["lateness_us"], Message.LatenessUs);
}

static void Read(const Json& Value, FHedgehogStatusLink& Message) {
  Read(Value["frames_out"], Message.FramesOut);
  Read(Value["lost"], Message.Lost);
  Read(Value["errors"], Message.Errors);
}

static void Read(const Json& Value, FHedgehogStatusLastTrip& Message) {
  Read(Value["reason"], Message.Reason);
  Read(Value["time_ns"], Message.TimeNs);
  Message.bHasTemperatureC = !Value["temperature_c"].is(Json::Kind::kNull);
  Read(Value["temperature_c"], Message.TemperatureC);
  Read(Value["current_a"], Message.CurrentA);
  Message.bHasDisagreement = !Value["disagreement"].is(Json::Kind::kNull);
  Read(Value["disagreement"], Message.Disagreement);
}

static void Read(const Json& Value, FHedgehogStatusPins& Message) {
  Read(Value["force_n"], Message.ForceN);
  Read(Value["extension_mm"], Message.ExtensionMm);
}

void Read(const Json& Value, FHedgehogStatus& Message) {
  Read(Value["device"], Message.Device);
  Read(Value["simulated"], Message.bSimulated);
  Read(Value["time_ns"], Message.TimeNs);
  Read(Value["state"], Message.State);
  Read(Value["reason"], Message.Reason);
  Read(Value["since_s"], Message.SinceS);
  Read(Value["remedy"], Message.Remedy);
  Read(Value["temperature_c"], Message.TemperatureC);
  Read(Value["limit_a"], Message.LimitA);
  Message.bHasHeadroomS = !Value["headroom_s"].is(Json::Kind::kNull);
  Read(Value["headroom_s"], Message.HeadroomS);
  Message.bHasBurstS = !Value["burst_s"].is(Json::Kind::kNull);
  Read(Value["burst_s"], Message.BurstS);
  Read(Value["derating"], Message.bDerating);
  Read(Value["current_a"], Message.CurrentA);
  Read(Value["duty"], Message.Duty);
  Message.bHasSupplyV = !Value["supply_v"].is(Json::Kind::kNull);
  Read(Value["supply_v"], Message.SupplyV);
  Message.Field = ToDirection(Value["field"]);
  Read(Value["force_n"], Message.ForceN);
  Message.bHasPin = !Value["pin"].is(Json::Kind::kNull);
  Read(Value["pin"], Message.Pin);
  Read(Value["fan"], Message.Fan);
  Message.bHasOrientation = !Value["orientation"].is(Json::Kind::kNull);
  Read(Value["orientation"], Message.Orientation);
  Read(Value["effects"], Message.Effects);
  Read(Value["loop"], Message.Loop);
  Read(Value["link"], Message.Link);
  Read(Value["applied_seq"], Message.AppliedSeq);
  Message.bHasLastTrip = !Value["last_trip"].is(Json::Kind::kNull);
  Read(Value["last_trip"], Message.LastTrip);
  Message.bHasPins = !Value["pins"].is(Json::Kind::kNull);
  Read(Value["pins"], Message.Pins);
  Message.Json = FString(UTF8_TO_TCHAR(Value.to_text().c_str()));
}

}  // namespace hedgehog::unreal
