// SPDX-License-Identifier: MIT
// Effects of a racing game: engine, gears, skids, hits and landings, to copy into a game.
// Directions are in Unreal's axes, in the car's frame: x forward, y right, z up.
#pragma once

#include <algorithm>
#include <cmath>

#include "hedgehog_subsystem.h"

/// Game thread; no call blocks.
class FHedgehogCarFeel {
 public:
  explicit FHedgehogCarFeel(UHedgehogSubsystem& InBall) : Ball(InBall) {}

  /// Every frame, 0 to 1 each. False: not connected.
  bool Engine(float Revolutions, float Throttle) {
    FHedgehogEffect Effect;
    Effect.FrequencyHz = 30.0f + 60.0f * Revolutions;
    Effect.Priority = kEngine;
    return Ball.RumbleWith(TEXT("engine"), 0.05f + 0.25f * Throttle, FVector(-1, 0, 0), Effect);
  }

  /// Every frame while the wheels slide; 0: full grip, 1: no grip. A skid lasts, so it is weaker
  /// than the strongest blow.
  void Skid(float Amount) {
    FHedgehogEffect Effect;
    Effect.Waveform = EHedgehogWaveform::Square;
    Effect.FrequencyHz = 60;
    Effect.Priority = kSkid;
    Ball.RumbleWith(TEXT("skid"), 0.5f * Amount, FVector(0, 0, -1), Effect);
  }

  /// The clutch has closed: a push from behind.
  void Gear() { Pulse(FVector(-1, 0, 0), 1, 40, kGear); }

  /// A hit of the car on that side, or a landing; returns its step, or -1 if it was too soon after
  /// another.
  int Blow(FVector Side, double ImpulseNs, double TimeS) {
    const int Step = StepOf(ImpulseNs);
    if (TimeS - LastS < kApartS && Step <= LastStep) return -1;
    LastStep = Step;
    LastS = TimeS;
    Pulse(Side, Step, 180, kBlow);
    return Step;
  }

  static int StepOf(double ImpulseNs) {
    const double Share = std::log(std::max(ImpulseNs, kSoftestBlow) / kSoftestBlow) /
                         std::log(kHardestBlow / kSoftestBlow);
    return static_cast<int>(std::lround((kSteps - 1) * std::min(Share, 1.0)));
  }

 private:
  /// Eight steps from the perception threshold to full strength are 32 % apart; people notice 13 %
  /// (thesis, experiment 2).
  static constexpr int kSteps = 8;
  /// Impulses of the first and the last step; Newton seconds.
  static constexpr double kSoftestBlow = 150.0;
  static constexpr double kHardestBlow = 8000.0;
  /// One blow in 0.25 s, except for a harder one.
  static constexpr double kApartS = 0.25;
  /// Of two effects only the one of higher priority is felt; of the same, both.
  static constexpr int kEngine = 3;
  static constexpr int kGear = 4;
  static constexpr int kSkid = 5;
  static constexpr int kBlow = 7;

  void Pulse(FVector Side, int Step, float DurationMs, int Priority) {
    if (!Ball.IsBallConnected()) return;
    const float FeltA = Ball.FeltA();
    FHedgehogEffect Effect;
    Effect.CurrentA =
        FeltA * std::pow(Ball.FullA() / FeltA, static_cast<float>(Step) / (kSteps - 1));
    Effect.DurationMs = DurationMs;
    Effect.Priority = Priority;
    Ball.Pulse(Side, Effect);
  }

  UHedgehogSubsystem& Ball;
  int LastStep = -1;
  double LastS = -kApartS;
};
