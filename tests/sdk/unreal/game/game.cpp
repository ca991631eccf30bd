// SPDX-License-Identifier: MIT
// A level with the quick start's actor in it, until the process is ended.
#include <chrono>
#include <memory>
#include <thread>

#include "hedgehog_subsystem.h"
#include "my_car.h"

int main() {
  const auto ball = std::make_shared<UHedgehogSubsystem>();
  ball->TimeoutS = 60;
  FSubsystemCollectionBase collection;
  ball->Initialize(collection);
  UGameInstance instance(ball);
  AMyCar car;
  car.stub_game_instance = &instance;
  AActor& actor = car;
  actor.DispatchBeginPlay();
  for (;;) {
    ball->Tick(0.016f);
    if (actor.PrimaryActorTick.bCanEverTick) actor.Tick(0.016f);
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
}
