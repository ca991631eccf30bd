// SPDX-License-Identifier: MIT
// hjif import according to its document and the reference software, against the timeline that they
// prescribe. The samples are our own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/clients/import_sample.h"

namespace hedgehog::client {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::UnorderedElementsAre;

std::string hjif(const std::string& bands, const std::string& more = R"("gain":1)",
                 const std::string& modality = "Vibrotactile") {
  return R"({"version":"2023","profile":"Main","level":1,"date":"","description":"a sample",)"
         R"("timescale":1000,"avatars":[],"perceptions":[{"id":0,"avatar_id":0,"description":"",)"
         R"("perception_modality":")" +
         modality +
         R"(","effect_library":[{"id":7,"effect_type":"Basis","position":0,"phase":0,)"
         R"("base_signal":"Sine","keyframes":[{"relative_position":0,"amplitude_modulation":0.3},)"
         R"({"relative_position":50,"amplitude_modulation":0.3}]}],"channels":[{"id":0,)"
         R"("description":"","mixing_coefficient":1,"body_part_mask":0,)" +
         more + R"(,"bands":[)" + bands + "]}]}]}";
}
std::string band(const std::string& type, const std::string& effects,
                 const std::string& curve = "Linear") {
  return R"({"band_type":")" + type + R"(","curve_type":")" + curve +
         R"(","lower_frequency_limit":0,"upper_frequency_limit":1000,"effects":[)" + effects + "]}";
}
std::string basis(int position, const std::string& keyframes, const std::string& signal = "Sine") {
  return R"({"effect_type":"Basis","position":)" + std::to_string(position) +
         R"(,"phase":0,"base_signal":")" + signal + R"(","keyframes":[)" + keyframes + "]}";
}
std::string key(int position, double amplitude, int hz = 0) {
  return R"({"relative_position":)" + std::to_string(position) + R"(,"amplitude_modulation":)" +
         std::to_string(amplitude) +
         (hz > 0 ? R"(,"frequency_modulation":)" + std::to_string(hz) : std::string()) + "}";
}

TEST(Hjif, CurvesGoFromKeyFrameToKeyFrame) {
  const auto i =
      import_pattern(
          hjif(band("Curve", basis(100, key(0, 0) + "," + key(50, 1) + "," + key(150, 0.2)))))
          .value();
  EXPECT_THAT(i.notes, IsEmpty());
  EXPECT_NEAR(level_at(i, 90), 0, 1e-3);
  EXPECT_NEAR(level_at(i, 125), 0.5, 1e-3);
  EXPECT_NEAR(level_at(i, 150), 1, 1e-3);
  EXPECT_NEAR(level_at(i, 200), 0.6, 1e-3);
  EXPECT_EQ(i.pattern.keyframes.back().t_ms, 250);
  EXPECT_EQ(i.pattern.waveform, std::nullopt);
}

TEST(Hjif, TransientsAreTapsAndTheGainCounts) {
  const auto i = import_pattern(hjif(band("Transient", basis(10, key(0, 0.8) + "," + key(60, 0.4))),
                                     R"("gain":0.5)"))
                     .value();
  EXPECT_NEAR(level_at(i, 20), 0.4, 1e-3);
  EXPECT_NEAR(level_at(i, 50), 0, 1e-3);
  EXPECT_NEAR(level_at(i, 80), 0.2, 1e-3);
}

TEST(Hjif, TheTimescaleIsTicksASecond) {
  std::string file = hjif(band("Curve", basis(4800, key(0, 1) + "," + key(4800, 1))));
  file.replace(file.find("1000"), 4, "48000");
  const auto i = import_pattern(file).value();
  EXPECT_NEAR(level_at(i, 95), 0, 1e-3);
  EXPECT_NEAR(level_at(i, 105), 1, 1e-3);
  EXPECT_EQ(i.pattern.keyframes.back().t_ms, 200);
}

TEST(Hjif, AVectorialWaveHasItsSignalAndItsFrequency) {
  const auto i =
      import_pattern(
          hjif(band("VectorialWave", basis(0, key(0, 1, 60) + "," + key(200, 0.5, 60), "Square"))))
          .value();
  EXPECT_EQ(i.pattern.waveform, model::Waveform::kSquare);
  EXPECT_EQ(i.pattern.frequency_hz, 60.0);
  EXPECT_NEAR(level_at(i, 100), 0.75, 1e-3);
  EXPECT_THAT(i.notes, IsEmpty());
}

TEST(Hjif, ReferencesPlayTheLibrarysEffects) {
  const auto i =
      import_pattern(hjif(band("Curve", R"({"effect_type":"Reference","id":7,"position":100})")))
          .value();
  EXPECT_NEAR(level_at(i, 125), 0.3, 1e-3);
  EXPECT_EQ(i.pattern.keyframes.back().t_ms, 150);
}

/// A key frame that contains only its frequency.
std::string only_hz(int position, int hz) {
  return R"({"relative_position":)" + std::to_string(position) + R"(,"frequency_modulation":)" +
         std::to_string(hz) + "}";
}

TEST(Hjif, AKeyFrameNeedNotHaveBothModulations) {
  const auto full =
      import_pattern(hjif(band("VectorialWave", basis(0, key(0, 1, 80) + "," + only_hz(100, 80) +
                                                             "," + key(200, 1)))))
          .value();
  EXPECT_NEAR(level_at(full, 100), 1, 1e-3);
  EXPECT_EQ(full.pattern.frequency_hz, 80.0);
  EXPECT_THAT(full.notes, IsEmpty());

  const auto held = import_pattern(hjif(band("VectorialWave",
                                             basis(0, only_hz(0, 80) + "," + key(50, 0.4) + "," +
                                                          key(100, 0.8) + "," + only_hz(200, 40)))))
                        .value();
  EXPECT_NEAR(level_at(held, 10), 0.4, 1e-3) << "the first that there is";
  EXPECT_NEAR(level_at(held, 75), 0.6, 1e-3);
  EXPECT_NEAR(level_at(held, 190), 0.8, 1e-3) << "the last one, to the effect's end";
  EXPECT_EQ(held.pattern.frequency_hz, 53.3) << "mean of 80 at 0.4 and 40 at 0.8";
  EXPECT_THAT(held.notes, ElementsAre(HasSubstr("played as their mean")));

  const auto plain =
      import_pattern(hjif(band("VectorialWave", basis(0, only_hz(0, 80) + "," + only_hz(99, 80)))))
          .value();
  EXPECT_NEAR(level_at(plain, 50), 1, 1e-3) << "a wave without amplitudes";

  const auto pitchless =
      import_pattern(hjif(band("VectorialWave", basis(0, key(0, 1) + "," + key(99, 1))))).value();
  EXPECT_EQ(pitchless.pattern.waveform, std::nullopt);
  EXPECT_THAT(pitchless.notes, ElementsAre(HasSubstr("without a frequency")));
}

TEST(Hjif, ACurveHasOnlyKeyFramesWithAnAmplitude) {
  const auto i =
      import_pattern(hjif(band("Curve", basis(0, key(0, 1) + "," + only_hz(50, 80) + "," +
                                                     key(100, 0) + "," + only_hz(300, 80)))))
          .value();
  EXPECT_NEAR(level_at(i, 50), 0.5, 1e-3);
  EXPECT_EQ(i.pattern.keyframes.back().t_ms, 100);
  const auto later = import_pattern(hjif(band("Curve", basis(100, key(50, 0.7))))).value();
  EXPECT_NEAR(level_at(later, 110), 0.7, 1e-3) << "the first one's, from the effect's beginning";
  EXPECT_EQ(later.pattern.keyframes.back().t_ms, 150);
}

TEST(Hjif, CubicCurvesBecomeTheEaseSmooth) {
  const std::string effect = basis(100, key(0, 0) + "," + key(100, 0.8) + "," + key(300, 0.2));
  const auto i = import_pattern(hjif(band("Curve", effect, "Cubic"))).value();
  EXPECT_THAT(i.notes, IsEmpty());
  EXPECT_LE(i.pattern.keyframes.size(), 5u);
  const auto smooth = [](double u) { return u * u * (3 - 2 * u); };
  for (int t_ms = 105; t_ms < 200; t_ms += 5)
    EXPECT_NEAR(level_at(i, t_ms), 0.8 * smooth((t_ms - 100) / 100.0), 1e-4) << t_ms;
  for (int t_ms = 205; t_ms < 400; t_ms += 5)
    EXPECT_NEAR(level_at(i, t_ms), 0.8 - 0.6 * smooth((t_ms - 200) / 200.0), 1e-4) << t_ms;
  const auto both =
      import_pattern(hjif(band("Curve", effect, "Cubic") + "," +
                          band("Curve", basis(150, key(0, 0.1) + "," + key(20, 0.1)))))
          .value();
  EXPECT_NEAR(level_at(both, 125), 0.8 * smooth(0.25), 4e-3);
  EXPECT_NEAR(level_at(both, 160), 0.8 * smooth(0.6) + 0.1, 4e-3) << "under another one";
  EXPECT_NEAR(level_at(both, 180), 0.8 * smooth(0.8), 4e-3);
  EXPECT_NEAR(level_at(both, 250), 0.8 - 0.6 * smooth(0.25), 1e-4) << "and alone again";

  std::string many = key(0, 0);
  for (int n = 1; n < 300; ++n) many += "," + key(20 * n, n % 2 == 0 ? 0.1 : 0.9);
  const auto cut = import_pattern(hjif(band("Curve", basis(0, many), "Cubic"))).value();
  EXPECT_THAT(cut.notes, ElementsAre(HasSubstr("more than 256")));
  EXPECT_EQ(error_message(cut), "");
}

TEST(Hjif, EffectsAfterAMinuteAreLeftOutAndReported) {
  const auto i =
      import_pattern(hjif(band("Curve", basis(50'000, key(0, 0) + "," + key(20'000, 1)) + "," +
                                            basis(70'000, key(0, 1) + "," + key(9, 1))) +
                          "," + band("Transient", basis(61'000, key(0, 1)))))
          .value();
  EXPECT_NEAR(level_at(i, 59'000), 0.45, 1e-3);
  EXPECT_EQ(i.pattern.keyframes.back().t_ms, 60'000);
  EXPECT_THAT(i.notes, UnorderedElementsAre(HasSubstr("begins after 60 s is left out"),
                                            HasSubstr("cut at 60 s")));
  const auto cubic =
      import_pattern(hjif(band("Curve", basis(50'000, key(0, 0) + "," + key(20'000, 1)), "Cubic")))
          .value();
  EXPECT_NEAR(level_at(cubic, 59'999), 0.5, 4e-3) << "half of a smooth way";
  EXPECT_NEAR(level_at(cubic, 55'000), 0.15625, 4e-3);
}

TEST(Hjif, UnplayableLibraryEffectsAreReported) {
  std::string file = hjif(band("Curve", R"({"effect_type":"Reference","id":7,"position":100},)" +
                                            basis(0, key(0, 1) + "," + key(9, 1))));
  file.replace(file.find("Basis"), 5, "Timeline");
  EXPECT_THAT(import_pattern(file).value().notes, ElementsAre(HasSubstr("'Timeline'")));
  const auto short_ones =
      import_pattern(hjif(band("Curve", basis(0, key(0, 1)) + "," + basis(0, "") + "," +
                                            basis(0, key(0, 1) + "," + key(9, 1)))))
          .value();
  EXPECT_THAT(short_ones.notes, ElementsAre(HasSubstr("that last no time are left out")));
  EXPECT_THAT(import_pattern(hjif(band("Transient", basis(0, key(0, 1) + "," + only_hz(50, 60)))))
                  .value()
                  .notes,
              Contains(HasSubstr("transients without an amplitude are left out")));
  EXPECT_THAT(
      import_pattern(hjif(band("Curve", basis(0, key(0, 1) + "," + key(9, 1))), R"("gain":1.5)"))
          .value()
          .notes,
      ElementsAre(HasSubstr("more than 1")));
}

TEST(Hjif, TheReferenceEncodersModalityIsReadAsVibrotactile) {
  const auto i =
      import_pattern(hjif(band("Transient", basis(0, key(0, 0.8))), R"("gain":1)", "Other"))
          .value();
  EXPECT_THAT(i.notes, ElementsAre(HasSubstr("'Other' are taken for vibrotactile")));
  EXPECT_NEAR(level_at(i, 10), 0.8, 1e-3);
}

TEST(Hjif, NegativePositionsWrittenAsUnsignedPrecedeTheirEffect) {
  const auto curve =
      import_pattern(hjif(band("Curve", basis(100, key(65'534, 1) + "," + key(48, 1))))).value();
  EXPECT_EQ(curve.pattern.keyframes.back().t_ms, 148);
  EXPECT_NEAR(level_at(curve, 99), 1, 1e-3);
  EXPECT_NEAR(level_at(curve, 97), 0, 1e-3);
  EXPECT_THAT(curve.notes, ElementsAre(HasSubstr("negative number of 16 bits")));

  const auto tap = import_pattern(hjif(band("Transient", basis(100, key(65'534, 1))))).value();
  EXPECT_EQ(tap.pattern.keyframes.back().t_ms, 123) << "alone";
  const auto cut = import_pattern(hjif(band("Transient", basis(0, key(65'534, 1))))).value();
  EXPECT_EQ(cut.pattern.keyframes.back().t_ms, 25) << "nothing is before the beginning";
  const auto several =
      import_pattern(hjif(band("Curve", basis(100, key(65'500, 0.5) + "," + key(65'534, 0.5) + "," +
                                                       key(0, 0.5) + "," + key(20, 0.5)))))
          .value();
  EXPECT_EQ(several.pattern.keyframes.back().t_ms, 120);
  EXPECT_NEAR(level_at(several, 65), 0.5, 1e-3);
  const std::string behind = basis(100, key(0, 1) + "," + key(50, 1) + "," + key(65'534, 1));
  const auto last = import_pattern(hjif(band("Curve", behind))).value();
  EXPECT_EQ(last.pattern.keyframes.back().t_ms, 150) << "written behind the others";
  EXPECT_THAT(last.notes, ElementsAre(HasSubstr("negative number of 16 bits")));
}

TEST(Hjif, LateKeyFramesInTheirOrderStayLate) {
  const auto i =
      import_pattern(hjif(band("Curve", basis(0, key(0, 1) + "," + key(40'000, 1))))).value();
  EXPECT_EQ(i.pattern.keyframes.back().t_ms, 40'000);
  EXPECT_THAT(i.notes, IsEmpty());
  std::string file =
      hjif(band("Curve", basis(0, key(0, 1) + "," + key(40'000, 1) + "," + key(65'500, 1))));
  file.replace(file.find("1000"), 4, "2000");
  const auto steady = import_pattern(file).value();
  EXPECT_EQ(steady.pattern.keyframes.back().t_ms, 32'750) << "others on the way to it";
  EXPECT_THAT(steady.notes, IsEmpty());
}

TEST(Hjif, UnsupportedPropertiesAreReported) {
  const std::string wave = band("VectorialWave", basis(0, key(0, 1, 40) + "," + key(99, 1, 90)));
  const std::string curve = band("Curve", basis(0, key(0, -1) + "," + key(99, 1)), "Akima");
  const auto i = import_pattern(hjif(wave + "," + curve + "," + band("WaveletWave", ""))).value();
  EXPECT_THAT(i.notes, Contains(HasSubstr("'Akima' are drawn with straight lines")));
  EXPECT_THAT(i.notes, Contains(HasSubstr("negative amplitudes are left out")));
  EXPECT_THAT(i.notes, Contains(HasSubstr("'WaveletWave' are left out")));
  EXPECT_THAT(i.notes, Contains(HasSubstr("waves are played as pushes")));
  EXPECT_THAT(import_pattern(hjif(curve, R"("gain":1)", "Temperature")).error().message,
              HasSubstr("'Temperature' are left out"));
}

std::string random_effect() {
  if (*rc::gen::inRange(0, 5) == 0) {
    return R"({"effect_type":"Reference","id":7,"position":)" +
           std::to_string(*rc::gen::inRange(0, 70'000)) + "}";
  }
  std::string keys;
  int position = 0;
  for (int n = *rc::gen::inRange(0, 30); n > 0; --n) {
    position += *rc::gen::inRange(0, 3000);
    const int hz = *rc::gen::inRange(0, 2) * *rc::gen::inRange(1, 400);
    const bool level = *rc::gen::inRange(0, 4) > 0;
    keys += (keys.empty() ? "" : ",") +
            (level ? key(position, *rc::gen::inRange(-2, 11) / 10.0, hz) : only_hz(position, hz));
  }
  return basis(*rc::gen::inRange(0, 70'000), keys,
               *rc::gen::element<std::string>("Sine", "Square", "SawToothDown"));
}

RC_GTEST_PROP(HjifLaw, ImportedPatternsAreAcceptedByTheDaemon, ()) {
  std::string bands =
      band("Curve", basis(*rc::gen::inRange(0, 59'000), key(0, 1) + "," + key(9, 1)));
  for (int n = *rc::gen::inRange(0, 6); n > 0; --n) {
    std::string effects = random_effect();
    for (int more = *rc::gen::inRange(0, 5); more > 0; --more) effects += "," + random_effect();
    bands += "," + band(*rc::gen::element<std::string>("Transient", "Curve", "VectorialWave"),
                        effects, *rc::gen::element<std::string>("Linear", "Cubic", "Akima"));
  }
  const auto imported = import_pattern(hjif(bands, R"("gain":0.8)"));
  RC_ASSERT(imported.has_value());
  RC_ASSERT(error_message(*imported) == "");
}

}  // namespace
}  // namespace hedgehog::client
