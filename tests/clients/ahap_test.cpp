// SPDX-License-Identifier: MIT
// AHAP import according to its document, against the timeline that it prescribes. The samples are
// our own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "clients/lib/import/trailing_commas.h"
#include "tests/clients/import_sample.h"

namespace hedgehog::client {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string ahap(const std::string& pattern) {
  return R"({"Version":1.0,"Metadata":{"Description":"a sample"},"Pattern":[)" + pattern + "]}";
}
std::string transient(double time_s, double intensity) {
  return R"({"Event":{"Time":)" + std::to_string(time_s) +
         R"(,"EventType":"HapticTransient","EventParameters":[)"
         R"({"ParameterID":"HapticIntensity","ParameterValue":)" +
         std::to_string(intensity) + "}]}}";
}
/// A continuous event of intensity 0.8 from 0.1 s to 0.5 s.
std::string continuous(const std::string& more = "") {
  return R"({"Event":{"Time":0.1,"EventType":"HapticContinuous","EventDuration":0.4,)"
         R"("EventParameters":[{"ParameterID":"HapticIntensity","ParameterValue":0.8})" +
         more + "]}}";
}
std::string value(const std::string& name, double v) {
  return R"(,{"ParameterID":")" + name + R"(","ParameterValue":)" + std::to_string(v) + "}";
}

TEST(Ahap, ATransientIsATapAtItsTime) {
  const auto i = import_pattern(ahap(transient(0.2, 0.6) + "," + transient(0.4, 1))).value();
  EXPECT_EQ(i.pattern.description, "a sample");
  EXPECT_THAT(i.notes, IsEmpty());
  EXPECT_NEAR(level_at(i, 199), 0, 1e-3);
  EXPECT_NEAR(level_at(i, 201), 0.6, 1e-3);
  EXPECT_NEAR(level_at(i, 224), 0.6, 1e-3);
  EXPECT_NEAR(level_at(i, 226), 0, 1e-3);
  EXPECT_NEAR(level_at(i, 410), 1, 1e-3);
  EXPECT_EQ(i.pattern.keyframes.back().t_ms, 425);
}

TEST(Ahap, AContinuousEventLastsForItsDuration) {
  const auto i = import_pattern(ahap(continuous())).value();
  EXPECT_NEAR(level_at(i, 99), 0, 1e-3);
  EXPECT_NEAR(level_at(i, 101), 0.8, 1e-3);
  EXPECT_NEAR(level_at(i, 499), 0.8, 1e-3);
  EXPECT_NEAR(level_at(i, 501), 0, 1e-3);
}

TEST(Ahap, AttackDecayAndReleaseAreItsEnvelope) {
  const auto held =
      import_pattern(ahap(continuous(value("AttackTime", 0.1) + value("ReleaseTime", 0.2))))
          .value();
  EXPECT_NEAR(level_at(held, 150), 0.4, 1e-3);
  EXPECT_NEAR(level_at(held, 300), 0.8, 1e-3);
  EXPECT_NEAR(level_at(held, 600), 0.4, 1e-3);
  EXPECT_EQ(held.pattern.keyframes.back().t_ms, 700);
  const auto envelope =
      import_pattern(ahap(continuous(value("AttackTime", 0.1) + value("DecayTime", 0.2) +
                                     value("Sustained", 0))))
          .value();
  EXPECT_NEAR(level_at(envelope, 300), 0.4, 1e-3);
  EXPECT_NEAR(level_at(envelope, 450), 0, 1e-3);
}

TEST(Ahap, AnEnvelopeCutByTheEndOfItsEventKeepsItsSlope) {
  const auto decay =
      import_pattern(ahap(continuous(value("DecayTime", 0.8) + value("Sustained", 0)))).value();
  EXPECT_NEAR(level_at(decay, 300), 0.6, 1e-3) << "a quarter of the decay";
  EXPECT_NEAR(level_at(decay, 499), 0.4, 2e-3) << "half of it";
  EXPECT_NEAR(level_at(decay, 501), 0, 1e-3);
  const auto attack = import_pattern(ahap(continuous(value("AttackTime", 0.8)))).value();
  EXPECT_NEAR(level_at(attack, 300), 0.2, 1e-3);
  EXPECT_NEAR(level_at(attack, 499), 0.4, 2e-3);
  const auto released =
      import_pattern(ahap(continuous(value("DecayTime", 0.8) + value("Sustained", 0) +
                                     value("ReleaseTime", 0.2))))
          .value();
  EXPECT_NEAR(level_at(released, 600), 0.2, 1e-3) << "from where the decay was";
}

TEST(Ahap, EventsAfterAMinuteAreLeftOutAndReported) {
  const auto late =
      import_pattern(ahap(transient(1, 0.5) + "," + transient(75, 0.5) + "," + transient(90, 1)))
          .value();
  EXPECT_EQ(late.pattern.keyframes.back().t_ms, 1025);
  EXPECT_THAT(late.notes, ElementsAre(HasSubstr("begins after 60 s is left out")));
  const std::string lasting =
      R"({"Event":{"Time":50,"EventType":"HapticContinuous","EventDuration":20,)"
      R"("EventParameters":[{"ParameterID":"HapticIntensity","ParameterValue":0.8}]}})";
  const auto cut = import_pattern(ahap(lasting + "," + transient(59.99, 0.1))).value();
  EXPECT_NEAR(level_at(cut, 55'000), 0.8, 1e-3);
  EXPECT_NEAR(level_at(cut, 59'995), 0.9, 1e-3);
  EXPECT_EQ(cut.pattern.keyframes.back().t_ms, 60'000);
  EXPECT_EQ(cut.pattern.keyframes.back().level, 0.0);
  EXPECT_THAT(cut.notes, ElementsAre(HasSubstr("cut at 60 s")));
  EXPECT_THAT(import_pattern(ahap(transient(60, 1))).error().message,
              HasSubstr("begins after 60 s"));
}

TEST(Ahap, ParameterCurvesAndDynamicParametersMultiplyTheIntensity) {
  const std::string curve =
      R"({"ParameterCurve":{"ParameterID":"HapticIntensityControl","Time":0.1,)"
      R"("ParameterCurveControlPoints":[{"Time":0,"ParameterValue":1},)"
      R"({"Time":0.2,"ParameterValue":0.5}]}})";
  const std::string parameter =
      R"({"Parameter":{"ParameterID":"HapticIntensityControl","ParameterValue":0.25,"Time":0.4}})";
  const auto i = import_pattern(ahap(continuous() + "," + curve + "," + parameter)).value();
  EXPECT_NEAR(level_at(i, 101), 0.8, 0.01);
  EXPECT_NEAR(level_at(i, 200), 0.6, 1e-3) << "half way from 1 to 0.5";
  EXPECT_NEAR(level_at(i, 350), 0.4, 1e-3) << "the curve's last value stays";
  EXPECT_NEAR(level_at(i, 399), 0.4, 1e-3);
  EXPECT_NEAR(level_at(i, 401), 0.2, 1e-3) << "until the parameter says otherwise";
}

TEST(Ahap, ACurveOverAnAttackIsAParabola) {
  const std::string curve =
      R"({"ParameterCurve":{"ParameterID":"HapticIntensityControl","Time":0.1,)"
      R"("ParameterCurveControlPoints":[{"Time":0,"ParameterValue":0},)"
      R"({"Time":0.4,"ParameterValue":1}]}})";
  const auto i = import_pattern(ahap(continuous(value("AttackTime", 0.4)) + "," + curve)).value();
  for (int t_ms = 105; t_ms < 500; t_ms += 5) {
    const double share = (t_ms - 100) / 400.0;
    EXPECT_NEAR(level_at(i, t_ms), 0.8 * share * share, 3e-3) << t_ms;
  }
}

TEST(Ahap, UnsupportedParametersAreReported) {
  const auto i =
      import_pattern(
          ahap(continuous(value("HapticSharpness", 0.5)) + "," + continuous() +
               R"(,{"Event":{"Time":0,"EventType":"AudioCustom"}})"
               R"(,{"ParameterCurve":{"ParameterID":"HapticSharpnessControl","Time":0}})"))
          .value();
  EXPECT_THAT(i.notes, Contains(HasSubstr("HapticSharpness is left out")));
  EXPECT_THAT(i.notes, Contains(HasSubstr("audio events are left out")));
  EXPECT_THAT(i.notes, Contains(HasSubstr("HapticSharpnessControl is left out")));
  EXPECT_THAT(i.notes, Contains(HasSubstr("cut there"))) << "0.8 and 0.8 are more than 1";
  EXPECT_NEAR(level_at(i, 300), 1.0, 1e-3);
  const std::string timeless = R"({"Event":{"Time":0.1,"EventType":"HapticContinuous"}})";
  EXPECT_THAT(import_pattern(ahap(transient(0, 1) + "," + timeless)).value().notes,
              ElementsAre(HasSubstr("without an EventDuration")));
}

TEST(Ahap, LongOnesAreSimplifiedNotRefused) {
  std::string many;
  for (int n = 0; n < 200; ++n) many += (n == 0 ? "" : ",") + transient(0.06 * n, 0.3 + 0.003 * n);
  const auto i = import_pattern(ahap(many)).value();
  EXPECT_LE(i.pattern.keyframes.size(), 256u);
  EXPECT_THAT(i.notes, Contains(HasSubstr("more than 256")));
}

TEST(Ahap, TrailingCommasAreAcceptedAndReported) {
  const std::string file =
      R"({"Version":1.0,"Metadata":{"Description":"a, b ,] and , }",},"Pattern":[)" +
      transient(0.2, 0.6) + " ,\n ] , }";
  const auto i = import_pattern(file).value();
  EXPECT_EQ(i.pattern.description, "a, b ,] and , }");
  EXPECT_NEAR(level_at(i, 210), 0.6, 1e-3);
  EXPECT_THAT(i.notes, ElementsAre(HasSubstr("commas behind a last item are left out")));
  for (const std::string wrong :
       {R"({"Pattern":[,]})", R"({"Pattern":[1,,]})", R"({"Pattern":,})", R"({,"Pattern":[]})",
        R"({"Pattern":[1,)", R"({"Pattern":["a,]})"})
    EXPECT_THAT(import_pattern(wrong).error().message, HasSubstr("not JSON")) << wrong;
}

TEST(TrailingCommas, NothingElseIsTouched) {
  for (const std::string unchanged :
       {R"("a,]")", R"(["\\",1])", R"("\",}")", R"([1,,])", R"([,])", R"({"a":,})", "[1,", R"("a,)",
        R"("\)", R"({"a,":[1,2,{"b":","}]})", ""})
    EXPECT_EQ(without_trailing_commas(unchanged), unchanged);
  EXPECT_EQ(without_trailing_commas(R"(["\\",])"), R"(["\\" ])");
  EXPECT_EQ(without_trailing_commas("{\"a\":[1,\t\n],}"), "{\"a\":[1 \t\n] }");
  EXPECT_EQ(without_trailing_commas("[[],{},\"\",]"), "[[],{},\"\" ]");
}

RC_GTEST_PROP(TrailingCommas, EveryTextKeepsItsLengthAndAllButCommas, (const std::string& text)) {
  const std::string made = without_trailing_commas(text);
  RC_ASSERT(made.size() == text.size());
  for (std::size_t i = 0; i < text.size(); ++i)
    RC_ASSERT(made[i] == text[i] || (text[i] == ',' && made[i] == ' '));
}

TEST(Ahap, ErrorsNameTheInvalidValue) {
  EXPECT_THAT(import_pattern("{").error().message, HasSubstr("not JSON"));
  EXPECT_THAT(import_pattern(ahap(transient(0, 1)) + '\0' + "garbage").error().message,
              HasSubstr("NUL at byte"));
  EXPECT_THAT(import_pattern("{}").error().message, HasSubstr("Pattern"));
  EXPECT_THAT(import_pattern(ahap("")).error().message, HasSubstr("no haptic event"));
  EXPECT_EQ(import_pattern("[]").error().failure, Failure::kBadData);
  EXPECT_THAT(import_pattern(R"({"a":1})").error().message, HasSubstr("neither AHAP"));
}

/// A number within `low`..`high`, often one of the bounds.
double some(double low, double high) {
  constexpr int kSteps = 1000;
  return low + (high - low) * std::clamp(*rc::gen::inRange(-200, kSteps + 200), 0, kSteps) / kSteps;
}

std::string random_entry() {
  const std::string time = R"(,"Time":)" + std::to_string(some(0, 80));
  if (*rc::gen::inRange(0, 4) > 0) {
    std::string parameters = R"({"ParameterID":"HapticIntensity","ParameterValue":1})";
    for (const char* name : {"HapticIntensity", "AttackTime", "DecayTime", "ReleaseTime"})
      if (*rc::gen::arbitrary<bool>()) parameters += value(name, some(0, 1));
    parameters += value("Sustained", *rc::gen::inRange(0, 2));
    const bool tap = *rc::gen::arbitrary<bool>();
    return R"({"Event":{"EventType":")" +
           (tap ? "HapticTransient\""
                : "HapticContinuous\",\"EventDuration\":" + std::to_string(some(0, 30))) +
           time + R"(,"EventParameters":[)" + parameters + "]}}";
  }
  std::string points;
  for (int n = *rc::gen::inRange(1, 30); n > 0; --n) {
    points += (points.empty() ? "" : ",") + (R"({"Time":)" + std::to_string(some(0, 70))) +
              R"(,"ParameterValue":)" + std::to_string(some(0, 1)) + "}";
  }
  return R"({"ParameterCurve":{"ParameterID":"HapticIntensityControl")" + time +
         R"(,"ParameterCurveControlPoints":[)" + points + "]}}";
}

RC_GTEST_PROP(AhapLaw, ImportedPatternsAreAcceptedByTheDaemon, ()) {
  std::string entries = transient(some(0, 59), 1);
  for (int n = *rc::gen::inRange(0, 40); n > 0; --n) entries += "," + random_entry();
  const auto imported = import_pattern(ahap(entries));
  RC_ASSERT(imported.has_value());
  RC_ASSERT(error_message(*imported) == "");
}

}  // namespace
}  // namespace hedgehog::client
