// SPDX-License-Identifier: MIT
// The ball in a game: one for each game instance, created automatically.
//
//   UHedgehogSubsystem* Ball = GetGameInstance()->GetSubsystem<UHedgehogSubsystem>();
//   Ball->Rumble(TEXT("engine"), 0.3f, FVector(-1, 0, 0), 70.0f);      // every frame
//   Ball->Pulse(FVector(0, -1, 0), FHedgehogEffect());
#pragma once

#include <functional>
#include <memory>

#include "CoreMinimal.h"
#include "Subsystems/GameInstanceSubsystem.h"
#include "Tickable.h"
#include "hedgehog_answer.h"
#include "hedgehog_effect.h"
#include "hedgehog_event.h"
#include "hedgehog_status.h"

#include "hedgehog_subsystem.generated.h"

namespace hedgehog::unreal {
class Client;
class Json;
struct Answer;
}  // namespace hedgehog::unreal

DECLARE_DYNAMIC_DELEGATE_OneParam(FHedgehogAnswered, const FHedgehogAnswer&, Answer);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHedgehogRefused, const FHedgehogAnswer&, Answer);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHedgehogEventReceived, const FHedgehogEvent&, Event);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHedgehogStatusReceived, const FHedgehogStatus&,
                                            Status);
DECLARE_DYNAMIC_MULTICAST_DELEGATE(FHedgehogConnected);
DECLARE_DYNAMIC_MULTICAST_DELEGATE_OneParam(FHedgehogDisconnected, const FString&, Reason);

/// Game thread; no call blocks, and everything continues while the game is paused. Lost connections
/// are re-established after 0.1 to 5 s. Directions are those in which the pins push out, in
/// Unreal's axes: x forward, y right, z up.
UCLASS(Config = Game)
class HEDGEHOGHAPTICS_API UHedgehogSubsystem : public UGameInstanceSubsystem,
                                               public FTickableGameObject {
  GENERATED_BODY()

 public:
  void Initialize(FSubsystemCollectionBase& Collection) override;
  void Deinitialize() override;
  void Tick(float DeltaTime) override;
  bool IsTickable() const override { return Client != nullptr; }
  bool IsTickableWhenPaused() const override { return true; }
  TStatId GetStatId() const override;

  /// True if effects can be played now.
  UFUNCTION(BlueprintPure, Category = "Hedgehog")
  bool IsBallConnected() const;

  /// Current at the perception threshold, and the strongest of this game (limits.felt_a and
  /// limits.current_a of hello), in ampere; 0: not connected.
  UFUNCTION(BlueprintPure, Category = "Hedgehog")
  float FeltA() const;
  UFUNCTION(BlueprintPure, Category = "Hedgehog")
  float FullA() const;

  /// A vibration that lasts while this is called every frame, and ends automatically 250 ms after
  /// the last call. Strength 0 to 1 starts at the perception threshold; 0 ends it. False: not
  /// connected.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  bool Rumble(const FString& Slot, float Strength, FVector Direction, float FrequencyHz = 60.0f);
  /// The same with further members of the effect: waveform, priority, another lease. Its slot,
  /// strength and duration are not used.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  bool RumbleWith(const FString& Slot, float Strength, FVector Direction,
                  const FHedgehogEffect& Effect);

  /// One push towards a direction.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Pulse(FVector Direction, const FHedgehogEffect& Effect);
  /// A push with a waveform.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Vibrate(FVector Direction, const FHedgehogEffect& Effect);
  /// A push that lasts as long as its lease is renewed.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Hold(FVector Direction, const FHedgehogEffect& Effect);
  /// The field moves round an axis, from pin to pin.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Circle(FVector Axis, const FHedgehogCircle& Effect);
  /// A named pattern: "heartbeat".
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Play(const FString& Pattern, const FHedgehogPlay& Effect);
  /// Ends the effect in a slot.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void Stop(const FString& Slot);
  /// Ends all effects of this game: for the pause menu.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void StopAll();

  /// Enables OnEvent, also after a lost connection; `bOfAll`: also for effects of other clients.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void SubscribeEvents(bool bOfAll = false);
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void UnsubscribeEvents();
  /// Enables OnStatus at this rate, 0.1 to 200; also after a lost connection.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void SubscribeStatus(float RateHz = 10.0f);
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void UnsubscribeStatus();

  /// Any method of the protocol; parameters as a JSON object, or empty.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Answered"))
  void Request(const FString& Method, const FString& Params, const FHedgehogAnswered& Answered);
  /// The same for C++.
  void Ask(const FString& Method, const FString& Params,
           std::function<void(const FHedgehogAnswer&)> Answered);

  UPROPERTY(BlueprintAssignable, Category = "Hedgehog")
  FHedgehogConnected OnConnected;
  UPROPERTY(BlueprintAssignable, Category = "Hedgehog")
  FHedgehogDisconnected OnDisconnected;
  UPROPERTY(BlueprintAssignable, Category = "Hedgehog")
  FHedgehogEventReceived OnEvent;
  UPROPERTY(BlueprintAssignable, Category = "Hedgehog")
  FHedgehogStatusReceived OnStatus;
  /// An effect was refused, or a subscription has ended because the daemon of a new connection
  /// refused it ("events.subscribe"); also written to the log.
  UPROPERTY(BlueprintAssignable, Category = "Hedgehog")
  FHedgehogRefused OnRefused;

  /// "127.0.0.1:7586"; empty: HEDGEHOG_ADDRESS, or that. Set in DefaultGame.ini, like the next.
  UPROPERTY(Config)
  FString Address;
  /// Timeout of connecting and of a response; seconds.
  UPROPERTY(Config)
  float TimeoutS = 2.0f;

 private:
  float Limit(const char* Name) const;
  void Start(const char* Method, const hedgehog::unreal::Json& Params);
  void Refuse(const char* Method, const hedgehog::unreal::Answer& Answer);

  /// Shared, so that only the .cpp requires its definition.
  std::shared_ptr<hedgehog::unreal::Client> Client;
};
