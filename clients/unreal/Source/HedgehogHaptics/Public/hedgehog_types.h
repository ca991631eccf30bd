// SPDX-License-Identifier: MIT
// What the ball tells a game.
#pragma once

#include "CoreMinimal.h"
#include "hedgehog_error.h"

#include "hedgehog_types.generated.h"

/// What came of a request.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogAnswer {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bOk = false;
  /// "effect.pulse".
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Method;
  /// JSON, as protocol/README.md describes it.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Result;
  /// Why not, one sentence: "the daemon does not run: ...", "level: 1.4 is above 1".
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Message;
  /// Why, of a refusal; for a switch.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  EHedgehogError Error = EHedgehogError::None;
  /// Of a refusal: the protocol's number and name, and the parameter that is wrong.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int32 Code = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Name;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Field;
};

/// Something happened: an effect began or ended, the state changed.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogEvent {
  GENERATED_BODY()

  /// "effect_ended", "state_changed".
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Type;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int64 Effect = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Slot;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Reason;
  /// All of it, JSON.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Json;
};

/// How the ball is.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatus {
  GENERATED_BODY()

  /// "armed", "disarmed", "tripped", "absent".
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString State;
  /// Of the hottest winding, as estimated; degrees Celsius.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float TemperatureC = 0.0f;
  /// The most that may flow now; ampere.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float LimitA = 0.0f;
  /// All of it, JSON.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Json;
};
