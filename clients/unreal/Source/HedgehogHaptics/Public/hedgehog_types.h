// SPDX-License-Identifier: MIT
// Data of the ball for a game.
#pragma once

#include "CoreMinimal.h"
#include "hedgehog_error.h"

#include "hedgehog_types.generated.h"

/// Outcome of a request.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogAnswer {
  GENERATED_BODY()

  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  bool bOk = false;
  /// "effect.pulse".
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Method;
  /// JSON, as in protocol/README.md.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Result;
  /// The error, one sentence: "the daemon does not run: ...", "level: 1.4 is above 1".
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Message;
  /// Kind of a refusal, for a switch.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  EHedgehogError Error = EHedgehogError::None;
  /// Of a refusal: the protocol's error code and name, and the invalid parameter.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  int32 Code = 0;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Name;
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Field;
};

/// An event: an effect started or ended, the state changed.
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
  /// The whole event, JSON.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Json;
};

/// Status of the ball.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogStatus {
  GENERATED_BODY()

  /// "armed", "disarmed", "tripped", "absent".
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString State;
  /// Of the hottest winding, estimated; degrees Celsius.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float TemperatureC = 0.0f;
  /// Present current limit; ampere.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  float LimitA = 0.0f;
  /// The whole status, JSON.
  UPROPERTY(BlueprintReadOnly, Category = "Hedgehog")
  FString Json;
};
