// SPDX-License-Identifier: MIT
// cpp_session ADDRESS: every method of the protocol once, as a program in C++ calls it.
#include <cstdint>
#include <cstdio>
#include <exception>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "clients/lib/ball.h"

namespace {

using namespace hedgehog;
using protocol::ErrorCode;
using protocol::Word;

constexpr client::Milliseconds kTimeout{60'000};

template <class T>
void expect_refused(const client::Outcome<T>& outcome, ErrorCode code) {
  if (outcome || !outcome.error().refusal || outcome.error().refusal->code != code)
    throw std::runtime_error("not refused as " + std::string(protocol::name(code)));
}

/// What starts or ends is waited for, so that the order of the session's lines is always the same.
void skip_to(Ball& ball, const std::string& type) {
  for (;;) {
    const auto notification = ball.next(kTimeout).value();
    if (!notification) throw std::runtime_error("no " + type);
    const auto* event = std::get_if<protocol::EventMessage>(&*notification);
    if (event != nullptr && event->event.type == type) return;
  }
}

std::vector<protocol::Keyframe> knock() {
  return {{.t_ms = 0, .direction = Word::kFront, .level = 1.0},
          {.t_ms = 60, .level = 0.0},
          {.t_ms = 120, .level = 0.6},
          {.t_ms = 180, .level = 0.0}};
}

void query(Ball& ball) {
  ball.call(protocol::Ping{}).value();
  ball.call(protocol::DeviceDescribe{}).value();
  ball.call(protocol::DeviceStatus{}).value();
  ball.call(protocol::DeviceList{}).value();
  ball.call(protocol::ConnectionList{}).value();
}

void play(Ball& ball) {
  ball.pulse(Word::kLeft, {.level = 0.6, .duration_ms = 60}).value();
  skip_to(ball, "effect_ended");
  ball.vibrate(model::Vec3{0.0, 1.0, 0.5},
               {.frequency_hz = 40.0, .lease_ms = 10'000, .slot = "engine"})
      .value();
  skip_to(ball, "effect_started");
  protocol::EffectUpdate weaker;
  weaker.params.slot = "engine";
  weaker.params.level = 0.3;
  ball.call(weaker).value();
  ball.call(protocol::EffectStop{.slot = "engine"}).value();
  skip_to(ball, "effect_ended");
  ball.hold(protocol::Angles{90.0, 20.0}, {.current_a = 4.0, .duration_ms = 80, .priority = 7})
      .value();
  skip_to(ball, "effect_ended");
  const auto turn = ball.circle(Word::kUp, {.duration_ms = 10'000,
                                            .speed_pins_s = 20.0,
                                            .sense = protocol::Sense::kClockwise})
                        .value();
  skip_to(ball, "effect_started");
  ball.call(protocol::EffectStop{.effect = turn.effect}).value();
  skip_to(ball, "effect_ended");
  ball.rumble("road", 0.4, Word::kDown, {.frequency_hz = 60.0, .lease_ms = 10'000});
  skip_to(ball, "effect_started");
  ball.rumble("road", 0.0);
  skip_to(ball, "effect_ended");
  ball.hold(protocol::PinNumber{34}, {.lease_ms = 10'000}).value();
  skip_to(ball, "effect_started");
  ball.call(protocol::EffectStopAll{}).value();
  skip_to(ball, "effect_ended");
}

void manage_patterns(Ball& ball) {
  protocol::PatternPut put;
  put.pattern.name = "acme/knock";
  put.pattern.description = "Two knocks.";
  put.pattern.keyframes = knock();
  ball.call(put).value();
  ball.call(protocol::PatternList{}).value();
  ball.call(protocol::PatternGet{"acme/knock"}).value();
  ball.play("acme/knock", {.rotate_to = Word::kRight}).value();
  skip_to(ball, "effect_ended");
  ball.call(protocol::EffectStart{model::EffectMethod::kPlay, {.keyframes = knock(), .rate = 2.0}})
      .value();
  skip_to(ball, "effect_ended");
  ball.call(protocol::PatternRemove{"acme/knock"}).value();
}

void forecast_effects(Ball& ball) {
  protocol::EffectPreview preview;
  preview.start = protocol::EffectStart{model::EffectMethod::kPulse,
                                        {.direction = Word::kUp, .duration_ms = 20}};
  ball.call(preview).value();
  protocol::ThermalForecast forecast;
  forecast.current_a = 12.0;
  forecast.direction = Word::kLeft;
  ball.call(forecast).value();
  ball.call(protocol::EffectLatency{}).value();
}

void watch(Ball& ball) {
  protocol::StatusKeys keys;
  for (const auto key : {protocol::StatusKey::kState, protocol::StatusKey::kTemperatureC,
                         protocol::StatusKey::kCurrentA, protocol::StatusKey::kOrientation})
    keys.add(key);
  ball.call(protocol::TelemetrySubscribe{20.0, keys}).value();
  if (!ball.next(kTimeout).value()) throw std::runtime_error("no telemetry");
  ball.call(protocol::TelemetryUnsubscribe{}).value();
  ball.call(protocol::TelemetryHistory{10.0}).value();
  protocol::EventsHistory history;
  history.limit = 3;
  ball.call(history).value();
}

void operate(Ball& ball) {
  ball.call(protocol::DeviceClaim{2000}).value();
  ball.call(protocol::DeviceRelease{}).value();
  ball.call(protocol::OutputSetGain{0.8}).value();
  ball.call(protocol::OutputSetGain{1.0}).value();
  ball.call(protocol::OrientationRecenter{-40.0}).value();
  expect_refused(ball.call(protocol::OrientationSet{}), ErrorCode::kUnsupported);
  protocol::SimSet world;
  world.ambient_c = 24.0;
  world.fault = protocol::SimFault{};
  ball.call(world).value();
  ball.call(protocol::SimTruth{}).value();
  expect_refused(ball.call(protocol::DeviceEnterBootLoader{}), ErrorCode::kArmed);
  ball.call(protocol::DeviceEmergencyStop{}).value();
  skip_to(ball, "state_changed");
  expect_refused(ball.pulse(Word::kLeft), ErrorCode::kNotArmed);
  ball.call(protocol::DeviceArm{}).value();
  skip_to(ball, "state_changed");
}

void provoke_errors(Ball& ball) {
  const std::string sideways = R"({"direction":"sideways"})";
  expect_refused(ball.call_raw("effect.pulse", sideways), ErrorCode::kInvalidParams);
  expect_refused(ball.call_raw("effect.rattle", sideways), ErrorCode::kMethodNotFound);
  expect_refused(ball.call(protocol::EffectStop{.slot = "nothing"}), ErrorCode::kNoSuchEffect);
  expect_refused(ball.play("hartbeat"), ErrorCode::kNoSuchPattern);
}

void run(const std::string& address) {
  Ball ball(client::daemon_addresses(address).value(), {.name = "session/c++"});
  query(ball);
  ball.call(protocol::EventsSubscribe{{"effect_started", "effect_ended", "state_changed"}}).value();
  play(ball);
  manage_patterns(ball);
  forecast_effects(ball);
  watch(ball);
  operate(ball);
  provoke_errors(ball);
  ball.call(protocol::EventsUnsubscribe{}).value();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("cpp_session ADDRESS\n", stderr);
    return 64;
  }
  try {
    run(argv[1]);
  } catch (const std::exception& e) {
    std::fprintf(stderr, "cpp_session: %s\n", e.what());
    return 1;
  }
  return 0;
}
