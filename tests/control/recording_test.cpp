// SPDX-License-Identifier: MIT
// A recording replays bit for bit, and a changed one is detected.
#include "daemon/control/recording/recording.h"

#include <gtest/gtest.h>

#include <string>

#include "daemon/device/simulator/simulator_settings.h"
#include "tests/rig/rig.h"
#include "tests/temporary_folder.h"

namespace hedgehog::control {
namespace {

/// Ten busy seconds that end in a trip.
std::vector<std::byte> recorded_trip(FlightRecorder& recorder) {
  rig::Rig rig;
  rig.recorder = &recorder;
  rig.orient(model::axis_angle({0, 1, 0}, 20.0));
  rig.run_until_armed();
  model::RandomStream random(7);
  for (int i = 0; i < 100; ++i) {
    model::EffectSpec spec = rig::pulse({random.uniform(-1, 1), random.uniform(-1, 1), 0.5},
                                        random.uniform(0.0, 15.0), 50 + i);
    spec.waveform = i % 2 == 0 ? model::Waveform::kNoise : model::Waveform::kSine;
    spec.frame = i % 3 == 0 ? model::Frame::kWorld : model::Frame::kDevice;
    const auto effect = rig.start(spec);
    rig.run(60);
    if (i % 5 == 0) rig.stop(effect);
    if (i % 10 == 0) rig.skip_control(3);
    rig.run(40);
  }
  rig.set_faults(device::kSimSensorOpen);
  rig.run(100);
  EXPECT_TRUE(recorder.frozen());
  return recorder.take();
}

TEST(Replay, GivesTheSameBitsForSixSecondsBeforeATrip) {
  FlightRecorder recorder;
  const auto bytes = recorded_trip(recorder);
  State last = State::kArmed;
  const ReplayResult result = replay(bytes, [&](const ReplayedTick& tick) {
    EXPECT_TRUE(tick.same) << "tick " << tick.inputs.tick;
    last = tick.replayed.state;
  });
  EXPECT_EQ(result.error, ReplayError::kNone);
  EXPECT_EQ(result.different, 0u);
  EXPECT_GE(result.ticks, 6000u);
  EXPECT_EQ(name(last), "tripped") << "the tick of the trip is the last one";
}

TEST(Replay, DetectsOneChangedBit) {
  FlightRecorder recorder;
  auto bytes = recorded_trip(recorder);
  // In the last changed word of the outputs of the last tick.
  const std::size_t at = bytes.size() - sizeof(std::uint32_t) - sizeof(std::uint64_t);
  bytes[at] ^= std::byte{1};
  EXPECT_EQ(replay(bytes, {}).error, ReplayError::kNotARecording) << "damaged";
  bytes.resize(bytes.size() - sizeof(std::uint32_t));
  end_recording(bytes);
  EXPECT_EQ(replay(bytes, {}).different, 1u);
}

TEST(Replay, ADamagedByteAnywhereIsNotReplayed) {
  FlightRecorder recorder;
  const auto recording = recorded_trip(recorder);
  model::RandomStream random(11);
  for (int i = 0; i < 50; ++i) {
    auto bytes = recording;
    const auto at =
        static_cast<std::size_t>(random.uniform(0.0, 1.0) * static_cast<double>(bytes.size() - 1));
    bytes[at] ^= std::byte{0x40};
    const ReplayResult result = replay(bytes, {});
    EXPECT_NE(result.error, ReplayError::kNone) << at;
    EXPECT_EQ(result.ticks, 0u) << at;
  }
}

TEST(Replay, RefusesInvalidFilesAndOtherBuilds) {
  FlightRecorder recorder;
  auto bytes = recorded_trip(recorder);
  EXPECT_EQ(replay({}, {}).error, ReplayError::kNotARecording);
  EXPECT_EQ(replay(std::span(bytes).first(bytes.size() - 1), {}).error,
            ReplayError::kNotARecording);
  bytes[9] ^= std::byte{1};  // in the build id
  EXPECT_EQ(replay(bytes, {}).error, ReplayError::kOtherBuild);
  bytes[0] ^= std::byte{1};
  EXPECT_EQ(replay(bytes, {}).error, ReplayError::kNotARecording);
  EXPECT_EQ(replay_recording("/no/such/file", {}).error, ReplayError::kUnreadable);
}

TEST(Replay, ReadsFiles) {
  FlightRecorder recorder;
  const auto bytes = recorded_trip(recorder);
  const TemporaryFolder folder;
  const std::string path =
      folder.write("recording", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  const ReplayResult result = replay_recording(path, {});
  EXPECT_EQ(result.error, ReplayError::kNone);
  EXPECT_EQ(result.different, 0u);
  EXPECT_EQ(result.written_by, build_id());
}

TEST(Recorder, AFloodOfCommandsShortensItButItStaysConsistent) {
  FlightRecorder recorder(std::size_t{1} << 20);
  rig::Rig rig;
  rig.recorder = &recorder;
  rig.run_until_armed();
  for (int i = 0; i < 4000; ++i) {
    for (int k = 0; k < 3; ++k) rig.command(SetGain{1.0});
    rig.tick();
  }
  recorder.request();
  rig.tick();
  ASSERT_TRUE(recorder.frozen());
  const auto bytes = recorder.take();
  const ReplayResult result = replay(bytes, {});
  EXPECT_EQ(result.error, ReplayError::kNone);
  EXPECT_EQ(result.different, 0u);
  EXPECT_GT(result.ticks, 500u);
  EXPECT_LT(bytes.size(), (std::size_t{1} << 20) + 2 * sizeof(Controller));
}

TEST(Recorder, FreezesWhenAnArmedBallDisconnects) {
  FlightRecorder recorder;
  rig::Rig rig;
  rig.recorder = &recorder;
  rig.run_until_armed();
  rig.set_faults(device::kSimSilent);
  rig.run(500);
  EXPECT_EQ(rig.controller().state(), State::kAbsent);
  ASSERT_TRUE(recorder.frozen());
  EXPECT_EQ(replay(recorder.take(), {}).different, 0u);
  recorder.resume();
  rig.set_faults(0);
  rig.run(200);
  EXPECT_EQ(rig.controller().state(), State::kDisarmed);
  EXPECT_FALSE(recorder.frozen());
}

TEST(Recorder, ARequestWhileItIsFrozenIsForTheNextRecording) {
  FlightRecorder recorder;
  rig::Rig rig;
  rig.recorder = &recorder;
  recorder.request();
  rig.tick();
  ASSERT_TRUE(recorder.frozen());
  recorder.request();
  rig.run(5);
  recorder.resume();
  EXPECT_FALSE(recorder.frozen());
  rig.tick();
  EXPECT_TRUE(recorder.frozen());
  EXPECT_EQ(replay(recorder.take(), {}).ticks, 1u);
}

TEST(Recorder, ContinuesAfterItWasRead) {
  FlightRecorder recorder;
  rig::Rig rig;
  rig.recorder = &recorder;
  rig.run_until_armed();
  recorder.request();
  rig.run(5);
  ASSERT_TRUE(recorder.frozen());
  rig.run(100);
  recorder.resume();
  rig.run(50);
  EXPECT_FALSE(recorder.frozen());
  recorder.request();
  rig.tick();
  ASSERT_TRUE(recorder.frozen());
  const ReplayResult result = replay(recorder.take(), {});
  EXPECT_EQ(result.ticks, 51u);
  EXPECT_EQ(result.different, 0u);
}

}  // namespace
}  // namespace hedgehog::control
