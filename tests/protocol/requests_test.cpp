// SPDX-License-Identifier: MIT
// The parameters of all other methods.
#include "model/magnets/ball_geometry.h"
#include "protocol/wire/json.h"
#include "tests/protocol/decoding.h"

namespace hedgehog::protocol {
namespace {

using testing::HasSubstr;

TEST(Methods, TableIsSortedAndAddressedByTheMethod) {
  for (std::size_t i = 0; i < kMethods.size(); ++i) {
    EXPECT_EQ(method_named(kMethods[i].name), static_cast<Method>(i));
    EXPECT_EQ(method_of(empty_request(static_cast<Method>(i))), static_cast<Method>(i));
    if (i > 0) EXPECT_LT(kMethods[i - 1].name, kMethods[i].name);
  }
  EXPECT_EQ(method_named("effect.pulsee"), std::nullopt);
  EXPECT_EQ(method_named(""), std::nullopt);
}

TEST(Methods, RolesAreThoseOfTheDocument) {
  EXPECT_EQ(info(kMethodOf<DeviceEmergencyStop>).role, std::nullopt) << "anybody may stop the ball";
  EXPECT_EQ(info(kMethodOf<Hello>).role, std::nullopt);
  EXPECT_EQ(info(kMethodOf<DeviceStatus>).role, Role::kObserve);
  EXPECT_EQ(info(*method_named("effect.pulse")).role, Role::kPlay);
  EXPECT_EQ(info(kMethodOf<DeviceArm>).role, Role::kOperate);
  EXPECT_EQ(info(kMethodOf<DeviceEnterBootLoader>).role, Role::kOperate);
}

TEST(Methods, UnknownOnesNameTheNearest) {
  const RpcError error = refused("effect.puls", "{}");
  EXPECT_EQ(error.code, ErrorCode::kMethodNotFound);
  EXPECT_THAT(error.message, HasSubstr("did you mean 'effect.pulse'?"));
  EXPECT_EQ(refused("pattern.rename", "{}").code, ErrorCode::kMethodNotFound);
  EXPECT_EQ(refused("EFFECT.PULSE", "{}").code, ErrorCode::kMethodNotFound);
  EXPECT_LT(refused(std::string(50'000, 'm'), "{}").message.size(), 300u);
}

TEST(Requests, MethodsWithoutParametersTakeNone) {
  for (const std::string method :
       {"ping", "device.describe", "device.list", "device.status", "device.emergency_stop",
        "device.arm", "device.release", "device.enter_boot_loader", "telemetry.unsubscribe",
        "events.unsubscribe", "connection.list"}) {
    EXPECT_EQ(name(method_of(*only(line_of(method, "{}")).request)), method);
    const RpcError error = refused(method, R"({"x":1})");
    EXPECT_EQ(error.field, "x") << method;
    EXPECT_EQ(error.code, ErrorCode::kInvalidParams);
  }
}

TEST(Requests, Hello) {
  const Hello hello =
      accepted<Hello>("hello", R"({"client":"Racer/1.2","protocol":"1.0","token":"hht_5"})");
  EXPECT_EQ(hello, (Hello{"Racer/1.2", "1.0", "hht_5"}));
  EXPECT_EQ(accepted<Hello>("hello", "{}"), Hello{});
  accepted<Hello>("hello", R"({"protocol":"1.7"})");
  const RpcError error = refused("hello", R"({"protocol":"2.0"})");
  EXPECT_EQ(error.code, ErrorCode::kUnsupported);
  EXPECT_EQ(error.message, "protocol: this server speaks 1.0 to 1.x, not 2.0");
  EXPECT_EQ(error.limit, ErrorValue{"1.x"});
  EXPECT_EQ(refused("hello", R"({"protocol":"10.0"})").code, ErrorCode::kUnsupported);
  EXPECT_EQ(refused("hello", "{\"client\":\"" + std::string(129, 'c') + "\"}").field, "client");
}

TEST(Requests, Stops) {
  EXPECT_EQ(accepted<EffectStop>("effect.stop", R"({"slot":"skid"})").slot, "skid");
  EXPECT_EQ(accepted<EffectStop>("effect.stop", R"({"effect":3})").effect, 3u);
  EXPECT_EQ(refused("effect.stop", "{}").field, "effect");
  EXPECT_EQ(refused("effect.stop", R"({"effect":3,"slot":"skid"})").field, "slot");
  EXPECT_EQ(accepted<EffectStopAll>("effect.stop_all", "{}").scope, Scope::kMine);
  EXPECT_EQ(accepted<EffectStopAll>("effect.stop_all", R"({"scope":"all"})").scope, Scope::kAll);
  EXPECT_THAT(refused("effect.stop_all", R"({"scope":"ours"})").message, HasSubstr("scope"));
}

TEST(Requests, ClaimAndGain) {
  EXPECT_EQ(accepted<DeviceClaim>("device.claim", R"({"lease_ms":250})").lease_ms, 250);
  EXPECT_EQ(refused("device.claim", R"({"lease_ms":99})").limit, ErrorValue{std::int64_t{100}});
  EXPECT_EQ(refused("device.claim", R"({"lease_ms":10001})").field, "lease_ms");
  EXPECT_EQ(accepted<OutputSetGain>("output.set_gain", R"({"gain":0.5})").gain, 0.5);
  EXPECT_EQ(refused("output.set_gain", R"({"gain":1.01})").field, "gain");
  EXPECT_EQ(refused("output.set_gain", "{}").message, "gain: is missing");
}

TEST(Requests, ForecastIsOfOneThing) {
  const auto forecast = [](std::string_view params) {
    return accepted<ThermalForecast>("thermal.forecast", params);
  };
  EXPECT_EQ(forecast(R"({"current_a":12})").current_a, 12.0);
  EXPECT_EQ(forecast(R"({"current_a":12,"direction":"up"})").direction, Direction{Word::kUp});
  EXPECT_EQ(forecast(R"({"effect":7})").effect, 7u);
  const ThermalForecast planned = forecast(
      R"({"method":"effect.vibrate","params":{"current_a":12,"frequency_hz":2,"on_fraction":0.15}})");
  ASSERT_TRUE(planned.start.has_value());
  EXPECT_EQ(planned.start->method, model::EffectMethod::kVibrate);
  EXPECT_EQ(planned.start->params.frequency_hz, 2.0);

  const auto field = [](std::string_view params) {
    return refused("thermal.forecast", params).field.value_or("");
  };
  EXPECT_EQ(field("{}"), "current_a");
  EXPECT_EQ(field(R"({"current_a":-1})"), "current_a");
  EXPECT_EQ(field(R"({"current_a":1,"effect":1})"), "effect");
  EXPECT_EQ(field(R"({"method":"effect.pulse"})"), "params");
  EXPECT_EQ(field(R"({"params":{}})"), "method");
  EXPECT_EQ(field(R"({"effect":1,"direction":"up"})"), "direction");
  EXPECT_EQ(field(R"({"method":"device.arm","params":{}})"), "method");
  EXPECT_EQ(field(R"({"method":"effect.pulse","params":{"direction":"up","level":2}})"),
            "params.level");
  EXPECT_EQ(field(R"({"method":"effect.pulse","params":{"direction":"up","slip":2}})"),
            "params.slip");
}

TEST(Requests, QuaternionsHaveLengthOne) {
  const OrientationSet exact =
      accepted<OrientationSet>("orientation.set", R"({"quaternion":{"w":1,"x":0,"y":0,"z":0}})");
  EXPECT_EQ(exact.quaternion, model::Quaternion{});
  const OrientationSet rounded = accepted<OrientationSet>(
      "orientation.set", R"({"quaternion":{"w":0.994,"x":-0.105,"y":0.035,"z":0}})");
  EXPECT_NEAR(model::norm(rounded.quaternion), 1.0, 1e-12);
  const auto field = [](std::string_view q) {
    return refused("orientation.set", R"({"quaternion":)" + std::string(q) + "}")
        .field.value_or("");
  };
  EXPECT_EQ(field(R"({"w":1,"x":1,"y":0,"z":0})"), "quaternion");
  EXPECT_EQ(field(R"({"w":0,"x":0,"y":0,"z":0})"), "quaternion");
  EXPECT_EQ(field(R"({"w":1e200,"x":0,"y":0,"z":0})"), "quaternion");
  EXPECT_EQ(field(R"({"w":1,"x":0,"y":0})"), "quaternion.z");
  EXPECT_EQ(field("[1,0,0,0]"), "quaternion");
}

TEST(Requests, Recenter) {
  EXPECT_EQ(accepted<OrientationRecenter>("orientation.recenter", "{}").azimuth_deg, 0.0);
  EXPECT_EQ(refused("orientation.recenter", R"({"azimuth_deg":400})").field, "azimuth_deg");
}

TEST(Requests, TelemetryFieldsAreKeysOfStatus) {
  const TelemetrySubscribe all = accepted<TelemetrySubscribe>("telemetry.subscribe", "{}");
  EXPECT_EQ(all.rate_hz, 10.0);
  EXPECT_TRUE(all.fields.contains(StatusKey::kOrientation));
  EXPECT_FALSE(all.fields.contains(StatusKey::kPins)) << "pins only when asked for";
  const TelemetrySubscribe some = accepted<TelemetrySubscribe>(
      "telemetry.subscribe", R"({"rate_hz":100,"fields":["orientation","pins"]})");
  EXPECT_TRUE(some.fields.contains(StatusKey::kPins));
  EXPECT_FALSE(some.fields.contains(StatusKey::kState));
  EXPECT_EQ(refused("telemetry.subscribe", R"({"rate_hz":500})").message,
            "rate_hz: 500 is above 200");
  const RpcError error = refused("telemetry.subscribe", R"({"fields":["orientatoin"]})");
  EXPECT_EQ(error.field, "fields[0]");
  EXPECT_THAT(error.message, HasSubstr("'orientation'"));
  EXPECT_EQ(refused("telemetry.subscribe", R"({"fields":[]})").field, "fields");
}

TEST(Requests, EventTypesAreKnown) {
  const EventsSubscribe some =
      accepted<EventsSubscribe>("events.subscribe", R"({"types":["effect_ended"],"scope":"all"})");
  EXPECT_EQ(some.types, std::vector<std::string>{"effect_ended"});
  EXPECT_EQ(some.scope, Scope::kAll);
  EXPECT_THAT(refused("events.subscribe", R"({"types":["efect_ended"]})").message,
              HasSubstr("'effect_ended'"));
  EXPECT_EQ(refused("events.subscribe", R"({"types":"all"})").field, "types");
}

TEST(Requests, Simulator) {
  const SimSet set = accepted<SimSet>(
      "sim.set", R"({"ambient_c":30,"fault":{"faults":["fan_stopped"],"coil":2}})");
  EXPECT_EQ(set.ambient_c, 30.0);
  EXPECT_EQ(set.fault->faults, std::vector<std::string>{"fan_stopped"});
  EXPECT_EQ(set.fault->coil, 2);
  EXPECT_EQ(accepted<SimSet>("sim.set", R"({"fault":{}})").fault, SimFault{});
  const SimSet errors = accepted<SimSet>(
      "sim.set",
      R"({"errors":[{"kind":"current_gain","coil":1,"value":1.05,"ramp_s":120},{"kind":"tach_gain","value":2}]})");
  ASSERT_EQ(errors.errors->size(), 2u);
  EXPECT_EQ(errors.errors->at(0), (SimError{"current_gain", 1, 1.05, 120.0}));
  EXPECT_EQ(errors.errors->at(1), (SimError{"tach_gain", std::nullopt, 2.0, 0.0}));
  EXPECT_EQ(refused("sim.set", R"({"errors":[{"kind":"current_gain"}]})").field, "errors[0].value");
  EXPECT_EQ(refused("sim.set", R"({"fault":{"coil":3}})").field, "fault.coil");
  EXPECT_EQ(refused("sim.set", R"({"ambient_c":200})").field, "ambient_c");
}

TEST(Directions, ResolveToUnitVectors) {
  const model::PinArray& ball = model::thesis_ball().array;
  EXPECT_EQ(*resolve(Word::kLeft, ball), (model::Vec3{0, 1, 0}));
  EXPECT_EQ(*resolve(model::Vec3{0, 0, -7}, ball), (model::Vec3{0, 0, -1}));
  EXPECT_EQ(*resolve(model::Vec3{1e-320, 0, 0}, ball), (model::Vec3{1, 0, 0}));
  EXPECT_NEAR(model::norm(*resolve(model::Vec3{1e300, 1e300, 0}, ball)), 1.0, 1e-12);
  EXPECT_NEAR(resolve(Angles{90, 0}, ball)->y, 1.0, 1e-12);
  EXPECT_EQ(*resolve(PinNumber{0}, ball), (model::Vec3{0, 0, 1}));
  const RpcError error = resolve(PinNumber{86}, ball, "axis").error();
  EXPECT_EQ(error.field, "axis.pin");
  EXPECT_EQ(error.limit, ErrorValue{std::int64_t{85}});
}

}  // namespace
}  // namespace hedgehog::protocol
