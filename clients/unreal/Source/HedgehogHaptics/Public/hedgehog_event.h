// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
// Optional members have a bHas... beside them; an optional text or list that was not sent is empty. Vectors and quaternions are in
// Unreal's axes: x forward, y right, z up. Json has all fields, also those that are newer than this version.
#pragma once

#include "CoreMinimal.h"

#include "hedgehog_event.generated.h"

UENUM(BlueprintType)
enum class EHedgehogEventType : uint8 {
  /// One of a later daemon: see TypeName.
  Other,
  DeratingEnded,
  DeratingStarted,
  DeviceAttached,
  DeviceDetached,
  EffectEnded,
  EffectStarted,
  MeasurementAccepted,
  MeasurementRejected,
  OrientationLost,
  OrientationRestored,
  Overrun,
  ShuttingDown,
  StateChanged,
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogEventDelivered {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Min = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float Mean = 0.0f;
};

USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogEventDisagreement {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Coil = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  TArray<FString> Between;
};

/// An event: an effect has started or ended, the state has changed.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogEvent {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  EHedgehogEventType Type = EHedgehogEventType::Other;
  /// As sent: "effect_ended".
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString TypeName;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 TimeNs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString State;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasEffect = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Effect = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Slot;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasSeq = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Seq = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Reason;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Remedy;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasOnsetNs = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 OnsetNs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasOffsetNs = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 OffsetNs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasDelivered = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogEventDelivered Delivered;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasMaskedMs = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 MaskedMs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasMixedMs = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 MixedMs = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasLimitA = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float LimitA = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasTemperatureC = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float TemperatureC = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasCurrentA = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float CurrentA = 0.0f;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasDisagreement = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FHedgehogEventDisagreement Disagreement;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Device;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bHasSkipped = false;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Skipped = 0;
  /// The whole message.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Json;
};
