// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
// Optional members have a bHas... beside them; an optional text or list that was not sent is empty. Vectors and quaternions are in
// Unreal's axes: x forward, y right, z up. Json has all fields, also those that are newer than this version.
#pragma once

#include "CoreMinimal.h"
#include "hedgehog_event.h"

#include "hedgehog_status.generated.h"

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusTemperatureC {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasSensor = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Sensor = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasModel = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Model = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  TArray<float> Coils;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasUpper = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Upper = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasCore = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Core = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  TArray<float> Sensors;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasSkin = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Skin = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasAgeMs = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 AgeMs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasThermometer = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Thermometer = 0.0f;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusFan {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasSpeedRpm = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float SpeedRpm = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Duty = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasCooling = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bCooling = false;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusOrientation {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FQuat Quaternion = FQuat::Identity;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FVector Up = FVector::ZeroVector;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FVector RateDegS = FVector::ZeroVector;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 AgeMs = 0;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusEffect {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Effect = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Slot;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Method;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Connection = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Client;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Priority = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bPlaying = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 RemainingMs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float CurrentA = 0.0f;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusLoopLatenessUs {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float P50 = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float P99 = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Max = 0.0f;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusLoop {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float RateHz = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Ticks = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Skipped = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogStatusLoopLatenessUs LatenessUs;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusLink {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 FramesOut = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Lost = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Errors = 0;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusLastTrip {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Reason;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 TimeNs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasTemperatureC = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float TemperatureC = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float CurrentA = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasDisagreement = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogEventDisagreement Disagreement;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatusPins {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  TArray<float> ForceN;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  TArray<float> ExtensionMm;
};

/// The status of the ball.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatus {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Device;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bSimulated = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 TimeNs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString State;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Reason;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float SinceS = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Remedy;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogStatusTemperatureC TemperatureC;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float LimitA = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasHeadroomS = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float HeadroomS = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasBurstS = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float BurstS = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bDerating = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  TArray<float> CurrentA;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  TArray<float> Duty;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasSupplyV = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float SupplyV = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FVector Field = FVector::ZeroVector;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float ForceN = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasPin = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Pin = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogStatusFan Fan;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasOrientation = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogStatusOrientation Orientation;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  TArray<FHedgehogStatusEffect> Effects;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogStatusLoop Loop;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogStatusLink Link;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 AppliedSeq = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasLastTrip = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogStatusLastTrip LastTrip;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasPins = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogStatusPins Pins;
  /// The whole message.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Json;
};
