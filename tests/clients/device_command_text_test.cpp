// SPDX-License-Identifier: MIT
// The lines that hedgehog-gamepad --trace prints.
#include "clients/gamepad/device_command_text.h"

#include <gtest/gtest.h>

namespace hedgehog::gamepad {
namespace {

ff_effect effect_of(int type, int id, int length_ms) {
  ff_effect effect{};
  effect.type = static_cast<std::uint16_t>(type);
  effect.id = static_cast<std::int16_t>(id);
  effect.replay.length = static_cast<std::uint16_t>(length_ms);
  return effect;
}

TEST(DeviceCommandText, APeriodicEffectHasItsWaveAndOnlyWhatIsSet) {
  ff_effect sine = effect_of(FF_PERIODIC, 3, 20'000);
  sine.direction = 0x4000;
  sine.u.periodic.waveform = FF_SINE;
  sine.u.periodic.period = 10;
  sine.u.periodic.magnitude = 0x4000;
  EXPECT_EQ(to_text(UploadRequest{1, sine}),
            "upload 3: sine from 0x4000, 10 ms, magnitude 16384, length 20000 ms");
  sine.u.periodic.waveform = FF_SAW_DOWN;
  sine.u.periodic.offset = -5;
  sine.u.periodic.phase = 0x20;
  sine.u.periodic.envelope = {1000, 0, 200, 7};
  sine.replay.delay = 50;
  EXPECT_EQ(to_text(UploadRequest{1, sine}),
            "upload 3: falling sawtooth from 0x4000, 10 ms, magnitude 16384, offset -5, phase "
            "0x0020, attack 1000 ms from 0, fade 200 ms to 7, length 20000 ms, delay 50 ms");
}

TEST(DeviceCommandText, AConstantForceARampAndARumbleHaveTheirLevels) {
  ff_effect constant = effect_of(FF_CONSTANT, 0, 0);
  constant.direction = 0x0100;
  constant.u.constant.level = -8192;
  EXPECT_EQ(to_text(UploadRequest{1, constant}), "upload 0: constant -8192 from 0x0100, endless");
  ff_effect ramp = effect_of(FF_RAMP, 1, 30);
  ramp.u.ramp.start_level = -1;
  ramp.u.ramp.end_level = 2;
  EXPECT_EQ(to_text(UploadRequest{1, ramp}), "upload 1: ramp -1 to 2 from 0x0000, length 30 ms");
  ff_effect rumble = effect_of(FF_RUMBLE, 2, 30);
  rumble.u.rumble.strong_magnitude = 0xffff;
  EXPECT_EQ(to_text(UploadRequest{1, rumble}),
            "upload 2: rumble, strong 65535, weak 0, length 30 ms");
}

TEST(DeviceCommandText, OtherTypesHaveTheirNumber) {
  EXPECT_EQ(to_text(UploadRequest{1, effect_of(FF_SPRING, 4, 1)}),
            "upload 4: type 0x53, length 1 ms");
}

TEST(DeviceCommandText, PlaysStopsErasesAndGain) {
  EXPECT_EQ(to_text(PlayCommand{5, 1}), "play 5, 1 time");
  EXPECT_EQ(to_text(PlayCommand{5, 3}), "play 5, 3 times");
  EXPECT_EQ(to_text(PlayCommand{5, 0}), "stop 5");
  EXPECT_EQ(to_text(EraseRequest{1, 6}), "erase 6");
  EXPECT_EQ(to_text(GainCommand{49'151}), "gain 49151");
}

}  // namespace
}  // namespace hedgehog::gamepad
