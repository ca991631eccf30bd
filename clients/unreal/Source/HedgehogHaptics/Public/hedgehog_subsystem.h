// SPDX-License-Identifier: MIT
// The ball in a game: one for each game instance, there without being created.
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
#include "hedgehog_effect.h"
#include "hedgehog_types.h"

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

/// Game thread; nothing waits, and everything works on while the game is paused. The daemon is
/// found again 0.1 to 5 s after it was lost. Directions are where the pins push out, in Unreal's
/// axes: x forward, y right, z up.
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

  /// Whether effects are played now.
  UFUNCTION(BlueprintPure, Category = "Hedgehog")
  bool IsBallConnected() const;

  /// A vibration that goes on while this is called every frame, and ends by itself 250 ms after the
  /// last. Strength 0 to 1 begins where it can be felt; 0 ends it. False: no daemon runs.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  bool Rumble(const FString& Slot, float Strength, FVector Direction, float FrequencyHz = 60.0f);

  /// One push towards a direction.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Pulse(FVector Direction, const FHedgehogEffect& Effect);
  /// A push with a waveform.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Vibrate(FVector Direction, const FHedgehogEffect& Effect);
  /// A push that lasts as long as it is renewed.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Hold(FVector Direction, const FHedgehogEffect& Effect);
  /// The field walks round an axis, from pin to pin.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Circle(FVector Axis, const FHedgehogCircle& Effect);
  /// A named pattern: "heartbeat".
  UFUNCTION(BlueprintCallable, Category = "Hedgehog", meta = (AutoCreateRefTerm = "Effect"))
  void Play(const FString& Pattern, const FHedgehogPlay& Effect);
  /// Ends what plays in a slot.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void Stop(const FString& Slot);
  /// Ends all effects of this game: the pause menu.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void StopAll();

  /// From now on OnEvent comes, after a lost connection too; `bOfAll`: for effects of others too.
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void SubscribeEvents(bool bOfAll = false);
  UFUNCTION(BlueprintCallable, Category = "Hedgehog")
  void UnsubscribeEvents();
  /// From now on OnStatus comes so many times a second, 0.1 to 200; after a lost connection too.
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
  /// An effect was not played, or a subscription has ended as the daemon of a new connection
  /// refused it ("events.subscribe"); the log has a line too.
  UPROPERTY(BlueprintAssignable, Category = "Hedgehog")
  FHedgehogRefused OnRefused;

  /// "127.0.0.1:7586"; empty: HEDGEHOG_ADDRESS, or that. Of DefaultGame.ini, as the next.
  UPROPERTY(Config)
  FString Address;
  /// Connecting, and waiting for a response, take no longer; seconds.
  UPROPERTY(Config)
  float PatienceS = 2.0f;

 private:
  void Start(const char* Method, const hedgehog::unreal::Json& Params);
  void Refuse(const char* Method, const hedgehog::unreal::Answer& Answer);

  /// Shared, so that only the .cpp has to know it.
  std::shared_ptr<hedgehog::unreal::Client> Client;
};
