// SPDX-License-Identifier: MIT
// Accepted and rejected parameters of the methods that play (protocol/README.md).
#include "tests/protocol/decoding.h"

namespace hedgehog::protocol {
namespace {

using testing::HasSubstr;

EffectParams pulse(std::string_view more) {
  return accepted<EffectStart>("effect.pulse", R"({"direction":"left",)" + std::string(more) + "}")
      .params;
}
RpcError no_pulse(std::string_view more) {
  return refused("effect.pulse", R"({"direction":"left",)" + std::string(more) + "}");
}

TEST(EffectParams, DirectionsAreStoredAsRequested) {
  const auto direction = [](std::string_view given) {
    return accepted<EffectStart>("effect.pulse", R"({"direction":)" + std::string(given) + "}")
        .params.direction.value();
  };
  EXPECT_EQ(direction("\"left\""), Direction{Word::kLeft});
  EXPECT_EQ(direction("\"down\""), Direction{Word::kDown});
  EXPECT_EQ(direction("[0,-3,0.5]"), Direction(model::Vec3{0, -3, 0.5}));
  EXPECT_EQ(direction(R"({"azimuth_deg":-45,"elevation_deg":10})"), Direction(Angles{-45, 10}));
  EXPECT_EQ(direction(R"({"azimuth_deg":90})"), Direction(Angles{90, 0}));
  EXPECT_EQ(direction(R"({"pin":34})"), Direction(PinNumber{34}));
}

TEST(EffectParams, InvalidDirections) {
  const auto field = [](std::string_view given) {
    const RpcError error = refused("effect.pulse", R"({"direction":)" + std::string(given) + "}");
    EXPECT_EQ(error.code, ErrorCode::kInvalidParams) << given;
    return error.field.value_or("");
  };
  EXPECT_EQ(field("[0,0,0]"), "direction");
  EXPECT_EQ(field("[1,2]"), "direction");
  EXPECT_EQ(field("[1,2,3,4]"), "direction");
  EXPECT_EQ(field(R"([1,"2",3])"), "direction[1]");
  EXPECT_EQ(field("\"forward\""), "direction");
  EXPECT_EQ(field("7"), "direction");
  EXPECT_EQ(field("null"), "direction");
  EXPECT_EQ(field("{}"), "direction");
  EXPECT_EQ(field(R"({"azimuth":3})"), "direction");
  EXPECT_EQ(field(R"({"pin":-1})"), "direction.pin");
  EXPECT_EQ(field(R"({"pin":1.5})"), "direction.pin");
  EXPECT_EQ(field(R"({"pin":1,"azimuth_deg":2})"), "direction.azimuth_deg");
  EXPECT_EQ(field(R"({"azimuth_deg":361})"), "direction.azimuth_deg");
  EXPECT_EQ(field(R"({"azimuth_deg":0,"elevation_deg":-91})"), "direction.elevation_deg");
}

TEST(EffectParams, DirectionIsNeededWhereThereIsNoDefault) {
  EXPECT_EQ(refused("effect.pulse", "{}").field, "direction");
  EXPECT_EQ(refused("effect.hold", "{}").field, "direction");
  EXPECT_EQ(accepted<EffectStart>("effect.vibrate", "{}").params.direction, std::nullopt);
  EXPECT_EQ(accepted<EffectStart>("effect.circle", "{}").params.axis, std::nullopt);
}

TEST(EffectParams, AtMostOneStrength) {
  EXPECT_EQ(pulse(R"("level":0.62)").level, 0.62);
  EXPECT_EQ(pulse(R"("current_a":12)").current_a, 12.0);
  EXPECT_EQ(pulse(R"("force_n":0.1)").force_n, 0.1);
  EXPECT_EQ(no_pulse(R"("level":0.5,"current_a":3)").field, "current_a");
  EXPECT_EQ(no_pulse(R"("force_n":0.5,"current_a":3)").field, "force_n");
}

TEST(EffectParams, OutOfRangeNamesFieldLimitAndValue) {
  const RpcError error = no_pulse(R"("level":1.4)");
  EXPECT_EQ(error.code, ErrorCode::kInvalidParams);
  EXPECT_EQ(error.message, "level: 1.4 is above 1");
  EXPECT_EQ(error.field, "level");
  EXPECT_EQ(error.limit, ErrorValue{std::int64_t{1}});
  EXPECT_EQ(error.value, ErrorValue{1.4});
}

struct Bound {
  std::string field;
  double low;
  double high;
  double step;
};

class Bounds : public testing::TestWithParam<Bound> {};

TEST_P(Bounds, BothEndsAreAllowedAndNothingBeyond) {
  const Bound& bound = GetParam();
  const auto given = [&](double value) {
    return R"({"axis":"up",")" + bound.field + "\":" + std::to_string(value) + "}";
  };
  accepted<EffectStart>("effect.circle", given(bound.low));
  accepted<EffectStart>("effect.circle", given(bound.high));
  const RpcError below = refused("effect.circle", given(bound.low - bound.step));
  EXPECT_EQ(below.field, bound.field);
  EXPECT_THAT(below.message, HasSubstr(" is below "));
  const RpcError above = refused("effect.circle", given(bound.high + bound.step));
  EXPECT_EQ(above.field, bound.field);
  EXPECT_THAT(above.message, HasSubstr(" is above "));
  EXPECT_TRUE(above.limit && above.value);
}

INSTANTIATE_TEST_SUITE_P(
    EffectParams, Bounds,
    testing::Values(Bound{"level", 0, 1, 0.001}, Bound{"gain", 0, 1, 0.001},
                    Bound{"attack_level", 0, 1, 0.001}, Bound{"fade_level", 0, 1, 0.001},
                    Bound{"frequency_hz", 0.5, 250, 0.01}, Bound{"on_fraction", 0.05, 0.95, 0.001},
                    Bound{"duration_ms", 1, 10'000, 1}, Bound{"lease_ms", 100, 10'000, 1},
                    Bound{"delay_ms", 0, 10'000, 1}, Bound{"priority", 0, 9, 1},
                    Bound{"ring_deg", 0, 180, 0.1}, Bound{"speed_pins_s", 0.1, 100, 0.01}),
    [](const auto& instance) { return instance.param.field; });

TEST(EffectParams, WordsAreCheckedAndTheNearestIsNamed) {
  EXPECT_EQ(pulse(R"("waveform":"sawtooth")").waveform, model::Waveform::kSawtooth);
  EXPECT_EQ(pulse(R"("frame":"world")").frame, model::Frame::kWorld);
  EXPECT_EQ(no_pulse(R"("waveform":"sqare")").message,
            "waveform: there is no 'sqare'; did you mean 'square'?");
  EXPECT_THAT(no_pulse(R"("frame":"table")").message, HasSubstr("there is device, world and coil"));
}

TEST(EffectParams, UnknownOnesAreRefusedWithTheNearest) {
  EXPECT_EQ(no_pulse(R"("duration":100)").message,
            "duration: is not a parameter of effect.pulse; did you mean 'duration_ms'?");
  EXPECT_THAT(no_pulse(R"("levle":1)").message, HasSubstr("'level'"));
  EXPECT_THAT(no_pulse(R"("duty":0.1)").message, HasSubstr("'on_fraction'"));
  EXPECT_THAT(no_pulse(R"("amplitude":0.1)").message, HasSubstr("'level'"));
  EXPECT_EQ(no_pulse(R"("Level":1)").field, "Level");
  EXPECT_EQ(no_pulse(R"("axis":"up")").field, "axis") << "only circles have one";
  EXPECT_THAT(refused("effect.circle", R"({"direction":"up"})").message, HasSubstr("'axis'"));
  EXPECT_LT(no_pulse('"' + std::string(60'000, 'x') + "\":1").message.size(), 300u);
}

TEST(EffectParams, OneKindOfEnd) {
  EXPECT_EQ(pulse(R"("duration_ms":300)").duration_ms, 300);
  EXPECT_EQ(pulse(R"("lease_ms":300)").lease_ms, 300);
  EXPECT_EQ(no_pulse(R"("duration_ms":300,"lease_ms":300)").field, "lease_ms");
}

TEST(EffectParams, TimesAreRoundedToTicks) {
  EXPECT_EQ(pulse(R"("duration_ms":33.4)").duration_ms, 33);
  EXPECT_EQ(pulse(R"("delay_ms":0.2)").delay_ms, 0);
  EXPECT_EQ(no_pulse(R"("duration_ms":0.9)").field, "duration_ms");
  EXPECT_EQ(no_pulse(R"("priority":5.5)").message, "priority: must be a whole number");
}

TEST(EffectParams, AttackAndFadeFitIntoTheDuration) {
  EXPECT_EQ(pulse(R"("duration_ms":100,"attack_ms":40,"fade_ms":60)").fade_ms, 60);
  EXPECT_EQ(no_pulse(R"("duration_ms":100,"attack_ms":41,"fade_ms":60)").field, "fade_ms");
  EXPECT_EQ(no_pulse(R"("attack_ms":151)").field, "attack_ms") << "the default is 150 ms";
  EXPECT_EQ(no_pulse(R"("lease_ms":1000,"fade_ms":60)").field, "fade_ms");
  EXPECT_EQ(refused("effect.hold", R"({"direction":"up","fade_ms":60})").field, "fade_ms")
      << "a hold is leased";
  EXPECT_EQ(pulse(R"("lease_ms":1000,"attack_ms":60)").attack_ms, 60);
}

TEST(EffectParams, OneWayToGiveTheStart) {
  EXPECT_EQ(pulse(R"("start_at_ns":273660123456789)").start_at_ns, 273'660'123'456'789);
  EXPECT_EQ(no_pulse(R"("start_at_ns":5,"delay_ms":5)").field, "delay_ms");
  EXPECT_EQ(no_pulse(R"("start_at_ns":-5)").field, "start_at_ns");
  EXPECT_EQ(no_pulse(R"("start_at_ns":1e30)").field, "start_at_ns");
}

TEST(EffectParams, FinishOnCloseIsForShortEffects) {
  EXPECT_EQ(pulse(R"("on_close":"finish")").on_close, OnClose::kFinish);
  EXPECT_EQ(pulse(R"("on_close":"finish","duration_ms":2000)").duration_ms, 2000);
  EXPECT_EQ(no_pulse(R"("on_close":"finish","duration_ms":2001)").field, "duration_ms");
  EXPECT_EQ(no_pulse(R"("on_close":"finish","lease_ms":500)").field, "on_close");
  EXPECT_EQ(
      refused("effect.hold", R"({"direction":"up","on_close":"finish","lease_ms":200})").field,
      "on_close");
}

TEST(EffectParams, SlotHasOneToThirtyTwoCharacters) {
  EXPECT_EQ(pulse(R"("slot":"engine")").slot, "engine");
  std::string umlauts;
  for (int i = 0; i < 32; ++i) umlauts += "ü";
  EXPECT_EQ(pulse("\"slot\":\"" + umlauts + "\"").slot, umlauts);
  EXPECT_EQ(no_pulse("\"slot\":\"" + umlauts + "u\"").message,
            "slot: has 33 characters, more than 32");
  EXPECT_EQ(no_pulse(R"("slot":"")").field, "slot");
  for (const char* unprintable : {R"("slot":"a\nb")", R"("slot":"\u001b[31m")",
                                  R"("slot":"\u0000")", R"("slot":"\u007f")", R"("slot":"\u0085")"})
    EXPECT_EQ(no_pulse(unprintable).message, "slot: has a control character");
  EXPECT_EQ(pulse(R"("slot":"\u00a0")").slot, "\u00a0");
  EXPECT_EQ(no_pulse(R"("slot":5)").message, "slot: must be a string, not a number");
}

TEST(EffectParams, WrongTypesAreNamed) {
  EXPECT_EQ(no_pulse(R"("level":"1")").message, "level: must be a number, not a string");
  EXPECT_EQ(no_pulse(R"("level":null)").message, "level: must be a number, not null");
  EXPECT_EQ(no_pulse(R"("level":[1])").message, "level: must be a number, not a list");
  EXPECT_EQ(no_pulse(R"("waveform":1)").message, "waveform: must be a string, not a number");
}

TEST(EffectParams, UpdateNeedsExactlyOneTarget) {
  EXPECT_EQ(accepted<EffectUpdate>("effect.update", R"({"effect":41,"level":0.2})").effect, 41u);
  EXPECT_EQ(accepted<EffectUpdate>("effect.update", R"({"slot":"way"})").params.slot, "way");
  EXPECT_EQ(refused("effect.update", R"({"level":0.2})").field, "effect");
  EXPECT_EQ(refused("effect.update", R"({"effect":1,"slot":"x"})").field, "slot");
  EXPECT_EQ(refused("effect.update", R"({"effect":0})").field, "effect");
  EXPECT_EQ(refused("effect.update", R"({"effect":4294967296})").field, "effect");
  EXPECT_EQ(
      accepted<EffectUpdate>("effect.update", R"({"slot":"c","ring_deg":45})").params.ring_deg,
      45.0);
}

TEST(EffectParams, DefaultsAreThoseOfTheDocument) {
  const EffectParams pulse = with_defaults(model::EffectMethod::kPulse, {});
  EXPECT_EQ(pulse.duration_ms, 150);
  EXPECT_EQ(pulse.lease_ms, std::nullopt);
  EXPECT_EQ(pulse.priority, 5);
  EXPECT_EQ(pulse.waveform, model::Waveform::kConstant);
  const EffectParams circle = with_defaults(model::EffectMethod::kCircle, {});
  EXPECT_EQ(circle.axis, Direction{Word::kUp});
  EXPECT_EQ(circle.ring_deg, 90);
  EXPECT_EQ(circle.speed_pins_s, 10);
  EXPECT_EQ(circle.sense, Sense::kCounterClockwise);
  EXPECT_EQ(circle.stepping, Stepping::kPin);
  const EffectParams vibrate = with_defaults(model::EffectMethod::kVibrate, {});
  EXPECT_EQ(vibrate.direction, Direction{Word::kDown});
  EXPECT_EQ(vibrate.waveform, model::Waveform::kSquare);
  EXPECT_EQ(vibrate.frequency_hz, 60);
  EXPECT_EQ(vibrate.on_fraction, 0.5);
  EXPECT_EQ(with_defaults(model::EffectMethod::kHold, {}).lease_ms, 1000);
  EXPECT_EQ(with_defaults(model::EffectMethod::kHold, {.duration_ms = 5}).lease_ms, std::nullopt);
  for (const model::EffectMethod method :
       {model::EffectMethod::kPulse, model::EffectMethod::kCircle, model::EffectMethod::kVibrate,
        model::EffectMethod::kHold}) {
    const EffectParams filled = with_defaults(method, {});
    EXPECT_NE(filled.duration_ms.has_value(), filled.lease_ms.has_value())
        << "every output ends by itself";
  }
}

}  // namespace
}  // namespace hedgehog::protocol
