// SPDX-License-Identifier: MIT
// Written by generate.py from protocol/schema/openrpc.json.
// clang-format off
// An effect's parameters; what is not given is left to the daemon. protocol/README.md has them at length.
#pragma once

#include "CoreMinimal.h"

#include "hedgehog_effect.generated.h"

UENUM(BlueprintType)
enum class EHedgehogFrame : uint8 { Default, Device, World, Coil };

UENUM(BlueprintType)
enum class EHedgehogWaveform : uint8 { Default, Constant, Sine, Square, Triangle, Sawtooth, Noise };

UENUM(BlueprintType)
enum class EHedgehogOnClose : uint8 { Default, Stop, Finish };

UENUM(BlueprintType)
enum class EHedgehogIfLimited : uint8 { Default, Reduce, Refuse };

UENUM(BlueprintType)
enum class EHedgehogSense : uint8 { Default, Ccw, Cw };

UENUM(BlueprintType)
enum class EHedgehogStepping : uint8 { Default, Pin, Smooth };

/// What every effect has.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogEffect {
  GENERATED_BODY()

  /// The ball's own frame, the room's, or the raw coil axes (operate, up to 5 A).
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog")
  EHedgehogFrame Frame = EHedgehogFrame::Default;

  /// Strength as a part of limits.current_a.
  /// 0 to 1; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "1"))
  float Level = -1.0f;

  /// Strength as a current; at most limits.current_a.
  /// At least 0; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1"))
  float CurrentA = -1.0f;

  /// Strength as the force on the pin that is pointed at.
  /// At least 0; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1"))
  float ForceN = -1.0f;

  /// Multiplies the strength.
  /// 0 to 1; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "1"))
  float Gain = -1.0f;

  /// Device time of the onset.
  /// At least 0; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1"))
  int64 StartAtNs = -1;

  /// From now to the onset.
  /// 0 to 10000; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "10000"))
  float DelayMs = -1.0f;

  /// Linear rise, inside the duration.
  /// 0 to 10000; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "10000"))
  float AttackMs = -1.0f;

  /// Linear fall, inside the duration; not with a lease.
  /// 0 to 10000; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "10000"))
  float FadeMs = -1.0f;

  /// Where the rise begins, as a part of the strength.
  /// 0 to 1; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "1"))
  float AttackLevel = -1.0f;

  /// Where the fall ends, as a part of the strength.
  /// 0 to 1; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "1"))
  float FadeLevel = -1.0f;

  /// Runs between 0 and the strength.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog")
  EHedgehogWaveform Waveform = EHedgehogWaveform::Default;

  /// 0.5 to 250; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "250"))
  float FrequencyHz = -1.0f;

  /// The part of a period that a square is on.
  /// 0.05 to 0.95; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "0.95"))
  float OnFraction = -1.0f;

  /// The effect ends after it. Never together with lease_ms.
  /// 1 to 10000; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "10000"))
  float DurationMs = -1.0f;

  /// Ends after it unless renewed.
  /// 100 to 10000; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "10000"))
  float LeaseMs = -1.0f;

  /// "finish" lets an effect of up to 2000 ms play out after the connection ended.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog")
  EHedgehogOnClose OnClose = EHedgehogOnClose::Default;

  /// The connection's own name for an effect.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog")
  FString Slot;

  /// Only effects of the highest active priority are output; 8 and 9 need the role operate.
  /// 0 to 9; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "9"))
  int32 Priority = -1;

  /// "refuse": an error instead of a reduced effect.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog")
  EHedgehogIfLimited IfLimited = EHedgehogIfLimited::Default;
};

/// For effect.circle.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogCircle : public FHedgehogEffect {
  GENERATED_BODY()

  /// Angle between the axis and the circle; 90 is the equator.
  /// 0 to 180; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "180"))
  float RingDeg = -1.0f;

  /// Steps a second; a step is the pitch of the pins.
  /// 0.1 to 100; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "100"))
  float SpeedPinsS = -1.0f;

  /// As seen from outside along the axis.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog")
  EHedgehogSense Sense = EHedgehogSense::Default;

  /// From pin to pin, or gliding.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog")
  EHedgehogStepping Stepping = EHedgehogStepping::Default;
};

/// For effect.play.
USTRUCT(BlueprintType)
struct HEDGEHOGHAPTICS_API FHedgehogPlay : public FHedgehogEffect {
  GENERATED_BODY()

  /// So many times as fast.
  /// 0.1 to 10; -1: not given.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog", meta = (ClampMin = "-1", ClampMax = "10"))
  float Rate = -1.0f;

  /// Begins again at its end.
  UPROPERTY(EditAnywhere, BlueprintReadWrite, Category = "Hedgehog")
  bool bLoop = false;
};
