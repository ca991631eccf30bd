// SPDX-License-Identifier: MIT
// Outcome of a request.
#pragma once

#include "CoreMinimal.h"
#include "hedgehog_error.h"

#include "hedgehog_answer.generated.h"

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
