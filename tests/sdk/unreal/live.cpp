// SPDX-License-Identifier: MIT
// Runs the plugin's subsystem with the daemon at HEDGEHOG_ADDRESS: live SCENE. Prints what it
// receives.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <thread>

#include "clients/unreal/Example/car_feel.h"
#include "clients/unreal/Source/HedgehogHaptics/Public/hedgehog_subsystem.h"

namespace {

std::string text(const FString& value) { return stub_utf8(*value); }

void print(const std::string& line) {
  std::puts(line.c_str());
  std::fflush(stdout);
}

template <class Done>
void run_until(UHedgehogSubsystem& ball, Done done) {
  while (!done()) {
    if (ball.IsTickable()) ball.Tick(0.016f);
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

FHedgehogAnswer ask(UHedgehogSubsystem& ball, const char* method, const char* params) {
  FHedgehogAnswer came;
  bool answered = false;
  FHedgehogAnswered delegate;
  delegate.bound = [&](const FHedgehogAnswer& answer) {
    came = answer;
    answered = true;
  };
  ball.Request(UTF8_TO_TCHAR(method), UTF8_TO_TCHAR(params), delegate);
  run_until(ball, [&] { return answered; });
  return came;
}

void listen(UHedgehogSubsystem& ball) {
  ball.OnConnected.bound.push_back([] { print("connected"); });
  ball.OnDisconnected.bound.push_back(
      [](const FString& why) { print("disconnected " + text(why)); });
  ball.OnEvent.bound.push_back([](const FHedgehogEvent& event) {
    print("event " + text(event.TypeName) + " " + text(event.Slot) + " " + text(event.Reason));
  });
  ball.OnRefused.bound.push_back([](const FHedgehogAnswer& answer) {
    print("refused " + text(answer.Method) + " " + text(answer.Name) + " " + text(answer.Field) +
          (answer.Error == EHedgehogError::InvalidParams ? " InvalidParams" : " another error"));
  });
}

void effects(UHedgehogSubsystem& ball) {
  int started = 0;
  bool ended = false;
  ball.OnEvent.bound.push_back([&](const FHedgehogEvent& event) {
    if (event.Type == EHedgehogEventType::EffectStarted) ++started;
    if (event.Type != EHedgehogEventType::EffectEnded) return;
    ended = true;
    if (event.bHasOnsetNs && event.bHasOffsetNs && event.OnsetNs < event.OffsetNs) print("flowed");
  });
  ball.SubscribeEvents();
  FHedgehogEffect effect;
  effect.Level = 0.5f;
  effect.DurationMs = 30;
  effect.Waveform = EHedgehogWaveform::Square;
  ball.Vibrate(FVector(0, -1, 0), effect);
  run_until(ball, [&ended] { return ended; });
  effect.Slot = TEXT("Größe");
  effect.DurationMs = -1;
  effect.LeaseMs = 10000;
  ball.Hold(FVector(0, 0, 1), effect);
  FHedgehogCircle circle;
  circle.Sense = EHedgehogSense::Cw;
  circle.LeaseMs = 10000;
  ball.Circle(FVector(0, 0, 1), circle);
  FHedgehogPlay pattern;
  pattern.bLoop = true;
  pattern.LeaseMs = 10000;
  ball.Play(TEXT("heartbeat"), pattern);
  run_until(ball, [&started] { return started == 4; });
  print("playing " + text(ask(ball, "device.status", "").Result));
  ball.Stop(effect.Slot);
  ball.StopAll();
  effect = {};
  effect.Level = 1.4f;
  ball.Pulse(FVector(1, 0, 0), effect);
  print("no object: " + text(ask(ball, "ping", "[1]").Message));
  bool measured = false;
  ball.OnStatus.bound.push_back([&measured](const FHedgehogStatus& now) {
    measured = now.bSimulated && text(now.State) == "armed" && now.TemperatureC.Model > 10 &&
               now.TemperatureC.Coils.Num() == 3 && now.LimitA > 1 && now.Loop.RateHz > 100 &&
               now.bHasOrientation && now.Orientation.Up.Z > 0.99;
  });
  ball.SubscribeStatus(100);
  run_until(ball, [&measured] { return measured; });
  print("measured");
}

/// A lap of three seconds, a frame every 16 ms.
void racer(UHedgehogSubsystem& ball) {
  FHedgehogCarFeel feel(ball);
  run_until(ball, [&ball] { return ball.IsBallConnected(); });
  const auto blow = [&feel](const char* what, FVector side, double impulse_n_s, double time_s) {
    char line[64];
    std::snprintf(line, sizeof line, "%.2f s  %s: step %d", time_s, what,
                  feel.Blow(side, impulse_n_s, time_s));
    print(line);
  };
  for (int frame = 0; frame < 180; ++frame) {
    const double time_s = frame / 60.0;
    if (frame == 30 || frame == 60) {
      feel.Gear();
      print(frame == 30 ? "0.50 s  gear" : "1.00 s  gear");
    }
    if (frame > 60 && frame < 90) feel.Skid(static_cast<float>(frame - 60) / 30.0f);
    if (frame == 100) blow("wall", FVector(0.7, 0.7, 0), 5000, time_s);
    if (frame == 105) blow("crate", FVector(0, -1, 0), 300, time_s);
    if (frame == 150) blow("landing", FVector(0, 0, -1), 2500, time_s);
    feel.Engine(static_cast<float>(frame % 60) / 60.0f, 1.0f);
    ball.Tick(0.016f);
    std::this_thread::sleep_for(std::chrono::milliseconds(16));
  }
  ball.StopAll();
  ask(ball, "ping", "");
}

}  // namespace

int main(int count, char** arguments) {
  const std::string scene = count == 2 ? arguments[1] : "";
  UHedgehogSubsystem ball;
  listen(ball);
  FSubsystemCollectionBase collection;
  ball.TimeoutS = 60;
  ball.Initialize(collection);
  if (scene == "effects") {
    effects(ball);
  } else if (scene == "racer") {
    racer(ball);
  } else if (scene == "missing_daemon") {
    print(text(ask(ball, "ping", "").Message));
  } else if (scene == "outage") {
    // Until the process is terminated.
    ball.SubscribeEvents();
    ball.OnConnected.bound.push_back([&ball] { ball.Pulse(FVector(0, -1, 0), FHedgehogEffect()); });
    run_until(ball, [] { return false; });
  } else if (scene == "slow_name") {
    bool connected = false;
    ball.OnConnected.bound.push_back([&connected] { connected = true; });
    for (int frame = 0; frame < 30; ++frame) ball.Tick(0.016f);
    print(std::string("30 frames, ") + (connected ? "connected" : "not connected"));
    run_until(ball, [&connected] { return connected; });
  } else {
    return 64;
  }
  ball.Deinitialize();
  print(ball.IsTickable() ? "still there" : "over");
  return 0;
}
