// SPDX-License-Identifier: MIT
// Synthesised sounds as effects: clicks become pulses at their time, low tones a vibration on their
// side.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <sys/stat.h>
#include <sndfile.hh>

#include <algorithm>
#include <cmath>
#include <functional>

#include "clients/sound/slices.h"
#include "tests/clients/wav_sample.h"
#include "tests/temporary_folder.h"

namespace hedgehog::sound {
namespace {

using client::click;
using client::sine;
using Sound = std::function<std::pair<double, double>(double)>;

std::vector<Slice> slices_of(double seconds, const Sound& sound, SliceOptions options = {},
                             int rate_hz = client::kWavRateHz) {
  const TemporaryFolder folder;
  folder.write("sound.wav", client::wav_of(seconds, sound, rate_hz));
  SliceReader reader(SoundFile::open(folder.path("sound.wav")).value(), options);
  std::vector<Slice> slices;
  while (auto slice = reader.next()) slices.push_back(*std::move(slice));
  return slices;
}

struct Push {
  double at_ms;
  double azimuth_deg;
  double level;
};

std::vector<Push> pushes_of(const std::vector<Slice>& slices) {
  std::vector<Push> pushes;
  for (const Slice& slice : slices)
    for (const protocol::Keyframe& frame : slice.pulses)
      if (frame.level > 0.0)
        pushes.push_back({static_cast<double>(slice.start_ms + frame.t_ms),
                          std::get<protocol::Angles>(*frame.direction).azimuth_deg, frame.level});
  return pushes;
}

/// Whether any slice vibrates.
bool vibrates(const std::vector<Slice>& slices) {
  return std::any_of(
      slices.begin(), slices.end(),
      [](const Slice& one) {
        return std::any_of(
            one.vibration.begin(), one.vibration.end(),
            [](const protocol::Keyframe& frame) { return frame.level > 0.2; });
      });
}

TEST(Sound, TheCrossoverSaysWhichTonesVibrate) {
  const Sound tone = [](double t) { return std::pair(0.5 * sine(t, 200.0), 0.5 * sine(t, 200.0)); };
  EXPECT_FALSE(vibrates(slices_of(1.0, tone, {.low_hz = 100.0})));
  EXPECT_TRUE(vibrates(slices_of(1.0, tone, {.low_hz = 250.0})));
}

TEST(Sound, ClicksBecomePushesAtTheirTime) {
  const std::vector<double> times{0.1, 0.3, 0.498, 0.7, 1.25};
  const auto pushes = pushes_of(slices_of(2.0, [&](double t) {
    double sum = 0.0;
    for (const double at : times) sum += 0.8 * click(t, at);
    return std::pair(sum, sum);
  }));
  ASSERT_EQ(pushes.size(), times.size());
  for (std::size_t i = 0; i < times.size(); ++i) {
    EXPECT_NEAR(pushes[i].at_ms, 1000.0 * times[i], 10.0);
    EXPECT_NEAR(pushes[i].azimuth_deg, 0.0, 1.0) << "on both sides alike: the front";
    EXPECT_NEAR(pushes[i].level, 0.8, 0.15);
  }
}

TEST(Sound, AClickOnOneSidePushesThere) {
  const auto pushes =
      pushes_of(slices_of(1.0, [](double t) { return std::pair(click(t, 0.2), click(t, 0.6)); }));
  ASSERT_EQ(pushes.size(), 2u);
  EXPECT_NEAR(pushes[0].azimuth_deg, 90.0, 1.0);
  EXPECT_NEAR(pushes[1].azimuth_deg, -90.0, 1.0);
}

TEST(Sound, ALowToneOnTheLeftVibratesThere) {
  const auto slices = slices_of(2.0, [](double t) { return std::pair(0.5 * sine(t, 40.0), 0.0); });
  ASSERT_EQ(slices.size(), 4u);
  for (std::size_t i = 1; i < 3; ++i) {
    EXPECT_NEAR(slices[i].frequency_hz, 40.0, 2.0);
    ASSERT_FALSE(slices[i].vibration.empty());
    for (const protocol::Keyframe& frame : slices[i].vibration) {
      EXPECT_NEAR(frame.level, 0.5, 0.05);
      EXPECT_NEAR(std::get<protocol::Angles>(*frame.direction).azimuth_deg, 90.0, 1.0);
    }
  }
  EXPECT_LE(pushes_of(slices).size(), 1u) << "a steady tone is no onset after its first moment";
}

TEST(Sound, TheEnvelopeGoesOnFromSliceToSlice) {
  const auto slices = slices_of(3.0, [](double t) {
    const double level = 0.5 + 0.4 * sine(t, 0.4);
    return std::pair(level * sine(t, 60.0), 0.5 * level * sine(t, 60.0));
  });
  for (std::size_t i = 0; i + 1 < slices.size(); ++i) {
    const auto& end = slices[i].vibration.back();
    const auto& begin = slices[i + 1].vibration.front();
    EXPECT_EQ(end.t_ms, kSliceMs);
    EXPECT_EQ(begin.t_ms, 0);
    EXPECT_EQ(end.level, begin.level);
    EXPECT_EQ(end.direction, begin.direction);
  }
}

TEST(Sound, ASteadyHighToneAndSilenceAreNotFelt) {
  const auto tone = slices_of(1.0, [](double t) { return std::pair(0.5 * sine(t, 1000.0), 0.0); });
  EXPECT_LE(pushes_of(tone).size(), 1u);
  for (const Slice& slice : slices_of(1.0, [](double) { return std::pair(0.0, 0.0); })) {
    EXPECT_TRUE(slice.pulses.empty());
    EXPECT_TRUE(slice.vibration.empty());
  }
}

TEST(Sound, AQuietClickIsStillFelt) {
  SliceOptions options;
  options.felt = 0.4;
  const auto pushes = pushes_of(slices_of(
      0.5, [](double t) { return std::pair(0.1 * click(t, 0.2), 0.1 * click(t, 0.2)); }, options));
  ASSERT_EQ(pushes.size(), 1u);
  EXPECT_GT(pushes[0].level, 0.4) << "above what can be felt";
  EXPECT_LT(pushes[0].level, 0.5);
}

RC_GTEST_PROP(Sound, AClickIsFoundAtAnyTimeAndRate, ()) {
  const int rate_hz = *rc::gen::element(8000, 22050, 44100, 48000);
  const double at = *rc::gen::inRange(0, 900) / 1000.0;
  const double right = *rc::gen::inRange(0, 100) / 100.0;
  const auto pushes = pushes_of(slices_of(
      1.0, [&](double t) { return std::pair(0.9 * click(t, at), right * 0.9 * click(t, at)); }, {},
      rate_hz));
  RC_ASSERT(pushes.size() == 1u);
  RC_ASSERT(std::abs(pushes[0].at_ms - 1000.0 * at) <= 10.0);
  RC_ASSERT(std::abs(pushes[0].azimuth_deg - azimuth_deg(1.0, right)) <= 2.0);
}

RC_GTEST_PROP(Sound, KeyFramesAreAcceptedByTheDaemon, (std::vector<int> heights)) {
  const auto slices = slices_of(
      1.2,
      [&](double t) {
        if (heights.empty()) return std::pair(0.0, 0.0);
        const auto i = static_cast<std::size_t>(t * 1000.0);
        return std::pair(0.01 * (heights[i % heights.size()] % 100),
                         0.01 * (heights[(2 * i) % heights.size()] % 100));
      },
      {}, 8000);
  for (const Slice& slice : slices) {
    RC_ASSERT(slice.frequency_hz >= 0.5 && slice.frequency_hz <= 250.0);
    RC_ASSERT(std::fmod(slice.frequency_hz * kSliceMs / 1000.0, 1.0) == 0.0);
    for (const auto* frames : {&slice.pulses, &slice.vibration}) {
      if (frames->empty()) continue;
      RC_ASSERT(!protocol::check_keyframes(*frames));
      RC_ASSERT(frames->size() <= 256u);
      for (const protocol::Keyframe& frame : *frames)
        RC_ASSERT(frame.level >= 0.0 && frame.level <= 1.0);
    }
  }
}

/// A second of two channels, written in a format of libsndfile's.
void write_sound(const std::string& path, int format, const Sound& sound) {
  SndfileHandle file(path, SFM_WRITE, format, 2, client::kWavRateHz);
  ASSERT_EQ(file.error(), 0) << file.strError();
  std::vector<float> samples;
  for (int i = 0; i < client::kWavRateHz; ++i) {
    const auto [left, right] = sound(static_cast<double>(i) / client::kWavRateHz);
    samples.push_back(static_cast<float>(left));
    samples.push_back(static_cast<float>(right));
  }
  ASSERT_EQ(file.writef(samples.data(), client::kWavRateHz), client::kWavRateHz);
}

TEST(SoundFile, EveryFormatOfTheReadmeGivesTheSamePushes) {
  const TemporaryFolder folder;
  const std::string path = folder.path("sound");
  for (const int format :
       {SF_FORMAT_FLAC | SF_FORMAT_PCM_16, SF_FORMAT_OGG | SF_FORMAT_VORBIS,
        SF_FORMAT_AIFF | SF_FORMAT_PCM_16, SF_FORMAT_MPEG | SF_FORMAT_MPEG_LAYER_III}) {
    ASSERT_NO_FATAL_FAILURE(
        write_sound(path, format, [](double t) { return std::pair(0.8 * click(t, 0.4), 0.0); }));
    SliceReader reader(SoundFile::open(path).value(), {});
    std::vector<Slice> slices;
    while (auto slice = reader.next()) slices.push_back(*std::move(slice));
    const auto pushes = pushes_of(slices);
    ASSERT_EQ(pushes.size(), 1u) << std::hex << format;
    EXPECT_NEAR(pushes[0].at_ms, 400.0, 60.0) << std::hex << format;
    EXPECT_NEAR(pushes[0].azimuth_deg, 90.0, 5.0) << std::hex << format;
  }
}

TEST(SoundFile, NamesTheProblemOfAFile) {
  const TemporaryFolder folder;
  folder.write("text.wav", "no sound\n");
  folder.write("fast.wav", client::wav_of(
                               0.01, [](double) { return std::pair(0.0, 0.0); }, 500'000));
  folder.write("empty.wav", client::wav_of(0.0, [](double) { return std::pair(0.0, 0.0); }));
  ASSERT_EQ(::mkfifo(folder.path("fifo.wav").c_str(), 0600), 0);
  const auto error_of = [&](const char* name) {
    return SoundFile::open(folder.path(name)).error();
  };
  EXPECT_EQ(error_of("none.wav").failure, client::Failure::kNoInput);
  EXPECT_EQ(error_of("fifo.wav").message,
            folder.path("fifo.wav") + ": is a FIFO, not a regular file");
  EXPECT_EQ(error_of("text.wav").failure, client::Failure::kBadData);
  EXPECT_EQ(error_of("fast.wav").message,
            folder.path("fast.wav") + ": has 500000 samples a second; 8000 to 192000 are read");
  EXPECT_EQ(error_of("empty.wav").message, folder.path("empty.wav") + ": has no sound in it");
}

}  // namespace
}  // namespace hedgehog::sound
