// SPDX-License-Identifier: MIT
// Translation of a game's force-feedback effect into effects of the ball.
#include "clients/gamepad/effect_translation.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>
#include <rapidcheck/gtest.h>

#include "clients/gamepad/force_profile.h"
#include "model/magnets/ball_geometry.h"
#include "protocol/client_codec.h"
#include "protocol/server_codec.h"

namespace hedgehog::gamepad {
namespace {

using model::EffectMethod;
using model::Waveform;
using testing::ElementsAre;

ff_effect effect_of(int type, int length_ms = 200) {
  ff_effect effect{};
  effect.type = static_cast<std::uint16_t>(type);
  effect.replay.length = static_cast<std::uint16_t>(length_ms);
  return effect;
}
ff_effect constant(int direction, int level, int length_ms = 200) {
  ff_effect effect = effect_of(FF_CONSTANT, length_ms);
  effect.direction = static_cast<std::uint16_t>(direction);
  effect.u.constant.level = static_cast<std::int16_t>(level);
  return effect;
}
ff_effect periodic(int waveform, int period_ms, int magnitude, int direction = 0x8000) {
  ff_effect effect = effect_of(FF_PERIODIC);
  effect.direction = static_cast<std::uint16_t>(direction);
  effect.u.periodic.waveform = static_cast<std::uint16_t>(waveform);
  effect.u.periodic.period = static_cast<std::uint16_t>(period_ms);
  effect.u.periodic.magnitude = static_cast<std::int16_t>(magnitude);
  return effect;
}
ff_effect rumble(int strong, int weak) {
  ff_effect effect = effect_of(FF_RUMBLE);
  effect.u.rumble.strong_magnitude = static_cast<std::uint16_t>(strong);
  effect.u.rumble.weak_magnitude = static_cast<std::uint16_t>(weak);
  return effect;
}

protocol::EffectStart started(const ff_effect& effect, const TranslationOptions& options = {}) {
  const auto translated = translate(effect, options);
  EXPECT_TRUE(translated.start);
  return translated.start.value_or(protocol::EffectStart{});
}
model::Vec3 side(const protocol::Direction& direction) {
  return protocol::resolve(direction, model::thesis_ball().array).value();
}
void expect_side(const protocol::Direction& direction, const model::Vec3& expected) {
  const auto is = side(direction);
  EXPECT_NEAR(norm(model::Vec3{is.x - expected.x, is.y - expected.y, is.z - expected.z}), 0.0,
              1e-9);
}

const model::Vec3 kFront{1, 0, 0};
const model::Vec3 kLeft{0, 1, 0};
const model::Vec3 kRight{0, -1, 0};
const model::Vec3 kBack{-1, 0, 0};
const model::Vec3 kDown{0, 0, -1};

TEST(Translation, AConstantForcePushesTheSideThatItComesFrom) {
  const std::vector<std::pair<int, model::Vec3>> sides{
      {0x0000, kFront}, {0x4000, kRight}, {0x8000, kBack}, {0xC000, kLeft}};
  for (const auto& [direction, expected] : sides) {
    const auto start = started(constant(direction, 0x7fff));
    EXPECT_EQ(start.method, EffectMethod::kHold);
    expect_side(*start.params.direction, expected);
  }
}

TEST(Translation, ANegativeForcePushesTheOppositeSide) {
  expect_side(*started(constant(0x4000, -0x4000)).params.direction, kLeft);
}

TEST(Translation, AForceBecomesALevelThatCanBeFelt) {
  TranslationOptions options;
  options.felt_level = 0.14;
  EXPECT_DOUBLE_EQ(*started(constant(0, 0x7fff), options).params.level, 1.0);
  EXPECT_NEAR(*started(constant(0, 0x4000), options).params.level, 0.14 + 0.43, 1e-4);
  EXPECT_GT(*started(constant(0, 1), options).params.level, 0.14);
  options.full_level = 0.5;
  EXPECT_DOUBLE_EQ(*started(constant(0, -0x8000), options).params.level, 0.5);
}

TEST(Translation, ZeroForceSendsNothing) {
  EXPECT_FALSE(translate(constant(0, 0), {}).start);
  EXPECT_FALSE(translate(rumble(0, 0), {}).start);
  EXPECT_FALSE(translate(periodic(FF_SINE, 50, 0), {}).start);
}

TEST(Translation, RumbleHasNoDirectionAndTheFrequenciesOfItsMotors) {
  const auto strong = started(rumble(0xffff, 0));
  EXPECT_EQ(strong.method, EffectMethod::kVibrate);
  expect_side(*strong.params.direction, kDown);
  EXPECT_DOUBLE_EQ(*strong.params.level, 1.0);
  EXPECT_DOUBLE_EQ(*strong.params.frequency_hz, 60.0);
  EXPECT_DOUBLE_EQ(*started(rumble(0, 0x8000)).params.frequency_hz, 160.0);
  EXPECT_DOUBLE_EQ(*started(rumble(0x8000, 0x8000)).params.frequency_hz, 110.0);
  TranslationOptions options;
  options.rumble_direction = protocol::Word::kBack;
  expect_side(*started(rumble(1, 1), options).params.direction, kBack);
}

TEST(Translation, AWaveKeepsItsShapeFrequencyAndSide) {
  const std::vector<std::pair<int, Waveform>> forms{{FF_SQUARE, Waveform::kSquare},
                                                    {FF_TRIANGLE, Waveform::kTriangle},
                                                    {FF_SINE, Waveform::kSine},
                                                    {FF_SAW_UP, Waveform::kSawtooth},
                                                    {FF_SAW_DOWN, Waveform::kSawtooth}};
  for (const auto& [form, expected] : forms) {
    const auto start = started(periodic(form, 25, 0x7fff, 0xC000));
    EXPECT_EQ(start.method, EffectMethod::kVibrate);
    EXPECT_EQ(start.params.waveform, expected);
    EXPECT_DOUBLE_EQ(*start.params.frequency_hz, 40.0);
    expect_side(*start.params.direction, kLeft);
  }
  EXPECT_DOUBLE_EQ(*started(periodic(FF_SINE, 1, 0x7fff)).params.frequency_hz, 250.0);
  EXPECT_DOUBLE_EQ(*started(periodic(FF_SINE, 60'000, 0x7fff)).params.frequency_hz, 0.5);
}

TEST(Translation, AnOffsetAddsToAWaveAndANegativeOneBeyondItTurnsTheSide) {
  ff_effect wave = periodic(FF_SINE, 25, 0x1000, 0x0000);
  wave.u.periodic.offset = -0x2000;
  const auto start = started(wave);
  expect_side(*start.params.direction, kBack);
  EXPECT_NEAR(*start.params.level, 0.14 + 0.86 * 0x3000 / 0x7fff, 1e-9);
}

TEST(Translation, SdlsRumbleHasNoDirectionUnlessConfigured) {
  const ff_effect sdl = periodic(FF_SINE, 1000, 24575, 0x4000);
  const auto start = started(sdl);
  expect_side(*start.params.direction, kDown);
  EXPECT_DOUBLE_EQ(*start.params.frequency_hz, 60.0);
  TranslationOptions options;
  options.sdl_rumble = false;
  expect_side(*started(sdl, options).params.direction, kRight);
  EXPECT_DOUBLE_EQ(*started(sdl, options).params.frequency_hz, 1.0);
}

TEST(Translation, ReplayGivesDelayAndLengthAndNoLengthIsTheLongest) {
  ff_effect effect = constant(0, 0x7fff, 1234);
  effect.replay.delay = 56;
  EXPECT_EQ(translate(effect, {}).delay, Milliseconds(56));
  EXPECT_EQ(translate(effect, {}).length, Milliseconds(1234));
  EXPECT_EQ(translate(constant(0, 0x7fff, 0), {}).length, kMaxPlay);
  EXPECT_EQ(translate(constant(0, 0x7fff, 65'535), {}).length, kMaxPlay);
}

TEST(Translation, AnEnvelopeBecomesKeyFrames) {
  ff_effect effect = constant(0xC000, 0x7fff, 1000);
  effect.u.constant.envelope = {100, 0, 200, 0x4000};
  const auto start = started(effect);
  EXPECT_EQ(start.method, EffectMethod::kPlay);
  const auto& frames = *start.params.keyframes;
  ASSERT_EQ(frames.size(), 4u);
  EXPECT_EQ(frames[0].t_ms, 0);
  EXPECT_EQ(frames[0].level, 0.0);
  EXPECT_EQ(frames[1].t_ms, 100);
  EXPECT_EQ(frames[1].level, 1.0);
  EXPECT_EQ(frames[2].t_ms, 800);
  EXPECT_EQ(frames[3].t_ms, 1000);
  EXPECT_NEAR(frames[3].level, 0.57, 1e-4);
  for (const auto& frame : frames) expect_side(*frame.direction, kLeft);
}

TEST(Translation, AWaveWithAnEnvelopeRunsOnTopOfItsKeyFrames) {
  ff_effect effect = periodic(FF_TRIANGLE, 20, 0x7fff);
  effect.u.periodic.envelope.fade_length = 50;
  const auto start = started(effect);
  EXPECT_EQ(start.method, EffectMethod::kPlay);
  EXPECT_EQ(start.params.waveform, Waveform::kTriangle);
  EXPECT_DOUBLE_EQ(*start.params.frequency_hz, 50.0);
}

TEST(Translation, ARampThroughZeroChangesTheSideWhileNothingIsPushed) {
  ff_effect effect = effect_of(FF_RAMP, 1000);
  effect.direction = 0x4000;
  effect.u.ramp.start_level = 0x7fff;
  effect.u.ramp.end_level = -0x7fff;
  const auto start = started(effect);
  const auto& frames = *start.params.keyframes;
  ASSERT_EQ(frames.size(), 4u);
  expect_side(*frames[0].direction, kRight);
  EXPECT_EQ(frames[0].level, 1.0);
  for (const std::size_t middle : {1u, 2u}) {
    EXPECT_EQ(frames[middle].t_ms, 500);
    EXPECT_EQ(frames[middle].level, 0.0);
  }
  expect_side(*frames[1].direction, kRight);
  expect_side(*frames[2].direction, kLeft);
  expect_side(*frames[3].direction, kLeft);
  EXPECT_EQ(frames[3].level, 1.0);
}

TEST(Translation, ConditionEffectsAreRefused) {
  for (const int type : {FF_SPRING, FF_DAMPER, FF_FRICTION, FF_INERTIA, FF_CUSTOM})
    EXPECT_FALSE(can_translate(effect_of(type)));
  EXPECT_FALSE(can_translate(periodic(FF_CUSTOM, 20, 1)));
  for (const int type : {FF_RUMBLE, FF_CONSTANT, FF_RAMP})
    EXPECT_TRUE(can_translate(effect_of(type)));
}

TEST(ForceProfile, WhereAttackAndFadeOverlapTheFadeBeginsAtTheEndOfTheAttack) {
  const ff_envelope envelope{60, 0x7fff, 90, 0};
  EXPECT_THAT(force_profile(0.5, 0.5, 100, envelope, true),
              ElementsAre(ForcePoint{0, 1.0}, ForcePoint{60, 0.5}, ForcePoint{100, 0.0}));
}

TEST(ForceProfile, WithoutAnEndThereIsNoFade) {
  const ff_envelope envelope{10, 0, 90, 0};
  EXPECT_THAT(force_profile(-0.5, -0.5, 60'000, envelope, false),
              ElementsAre(ForcePoint{0, -0.0}, ForcePoint{10, -0.5}, ForcePoint{60'000, -0.5}));
}

ff_effect any_effect() {
  const auto u16 = [] { return *rc::gen::arbitrary<std::uint16_t>(); };
  const auto s16 = [] { return *rc::gen::arbitrary<std::int16_t>(); };
  ff_effect effect{};
  effect.type = *rc::gen::element<std::uint16_t>(FF_RUMBLE, FF_PERIODIC, FF_CONSTANT, FF_RAMP);
  effect.direction = u16();
  effect.replay = {u16(), u16()};
  const ff_envelope envelope{u16(), u16(), u16(), u16()};
  if (effect.type == FF_RUMBLE) {
    effect.u.rumble = {u16(), u16()};
  } else if (effect.type == FF_CONSTANT) {
    effect.u.constant = {s16(), envelope};
  } else if (effect.type == FF_RAMP) {
    effect.u.ramp = {s16(), s16(), envelope};
  } else {
    effect.u.periodic.waveform =
        *rc::gen::element<std::uint16_t>(FF_SQUARE, FF_TRIANGLE, FF_SINE, FF_SAW_UP, FF_SAW_DOWN);
    effect.u.periodic.period = u16();
    effect.u.periodic.magnitude = s16();
    effect.u.periodic.offset = s16();
    effect.u.periodic.envelope = envelope;
  }
  return effect;
}

RC_GTEST_PROP(Translation, IsAcceptedByTheDaemon, ()) {
  const auto translated = translate(any_effect(), {});
  RC_ASSERT(translated.length >= Milliseconds(1));
  RC_ASSERT(translated.length <= kMaxPlay);
  if (!translated.start) return;
  auto start = *translated.start;
  if (translated.length.count() > protocol::kMaxDurationMs)
    start.params.lease_ms = 500;
  else
    start.params.duration_ms = translated.length.count();
  const auto incoming = protocol::decode_line(protocol::encode_request(std::nullopt, start));
  RC_ASSERT(incoming.items.size() == 1u);
  const auto& request = incoming.items[0].request;
  if (!request) RC_FAIL(request.error().message);
  RC_ASSERT(*start.params.level <= 1.0);
  RC_ASSERT(*start.params.level >= 0.14);
}

}  // namespace
}  // namespace hedgehog::gamepad
