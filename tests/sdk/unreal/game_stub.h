// SPDX-License-Identifier: MIT
// As much of Unreal's API as the quick start's actor uses. Names are the engine's.
#pragma once

#include <memory>
#include <utility>

#include "tests/sdk/unreal/engine_stub.h"

/// Has one subsystem, which the engine would find by its class.
class UGameInstance {
 public:
  explicit UGameInstance(std::shared_ptr<UGameInstanceSubsystem> subsystem)
      : subsystem_(std::move(subsystem)) {}
  template <class T>
  T* GetSubsystem() const {
    return static_cast<T*>(subsystem_.get());
  }

 private:
  std::shared_ptr<UGameInstanceSubsystem> subsystem_;
};

struct FActorTickFunction {
  bool bCanEverTick = false;
};

class AActor {
 public:
  /// Of the classes derived from it; the header tool writes it.
  using Super = AActor;
  virtual ~AActor() = default;
  virtual void Tick(float) {}
  /// Once, when the level begins.
  void DispatchBeginPlay() { BeginPlay(); }
  UGameInstance* GetGameInstance() const { return stub_game_instance; }

  FActorTickFunction PrimaryActorTick;
  UGameInstance* stub_game_instance = nullptr;

 protected:
  virtual void BeginPlay() {}
};
