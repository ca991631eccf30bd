// SPDX-License-Identifier: MIT
// The daemon's output, byte for byte, and its decoding by a client.
#include "protocol/client_codec.h"
#include "tests/protocol/decoding.h"

namespace hedgehog::protocol {
namespace {

using testing::HasSubstr;

/// The status object of protocol/README.md.
Status example_status() {
  Status s;
  s.device = "ball-7";
  s.time_ns = 273'660'123'456'789;
  s.state = "armed";
  s.since_s = 273'590;
  s.temperature_c = {41.2, 41.6, {41.0, 41.6, 40.9}, 3};
  s.limit_a = 15;
  s.burst_s = 11.5;
  s.current_a = {0, 4.99, 0.12};
  s.duty = {0, 0.199, 0.005};
  s.supply_v = 12.014;
  s.field = {0, 0.9997, 0.024};
  s.force_n = 0.062;
  s.pin = 34;
  s.fan = {7180.0, 1.0};
  s.orientation =
      OrientationStatus{{0.994, -0.105, 0.035, 0}, {-0.069, -0.208, 0.976}, {0.1, 0, 0}, 3};
  s.effects = {{412, std::nullopt, "effect.circle", 7, "Racer/1.2", 5, true, 4400, 4.99}};
  s.loop = {1000, 273'600'000, 0, {12, 61, 240}};
  s.link = {273'600'000, 0, 0};
  s.applied_seq = 9120;
  return s;
}

constexpr std::string_view kExampleStatus =
    R"({"device":"ball-7","simulated":false,"time_ns":273660123456789,"state":"armed",)"
    R"("reason":null,"since_s":273590,"remedy":null,"temperature_c":{"sensor":41.2,"model":41.6,)"
    R"("coils":[41,41.6,40.9],"age_ms":3},"limit_a":15,"headroom_s":null,"burst_s":11.5,)"
    R"("derating":false,"current_a":[0,4.99,0.12],"duty":[0,0.199,0.005],"supply_v":12.014,)"
    R"("field":[0,0.9997,0.024],"force_n":0.062,"pin":34,"fan":{"speed_rpm":7180,"duty":1},)"
    R"("orientation":{"quaternion":{"w":0.994,"x":-0.105,"y":0.035,"z":0},)"
    R"("up":[-0.069,-0.208,0.976],"rate_deg_s":[0.1,0,0],"age_ms":3},)"
    R"("effects":[{"effect":412,"slot":null,"method":"effect.circle","connection":7,)"
    R"("client":"Racer/1.2","priority":5,"playing":true,"remaining_ms":4400,"current_a":4.99}],)"
    R"("loop":{"rate_hz":1000,"ticks":273600000,"skipped":0,)"
    R"("lateness_us":{"p50":12,"p99":61,"max":240}},)"
    R"("link":{"frames_out":273600000,"lost":0,"errors":0},"applied_seq":9120,"last_trip":null})";

std::string result_of(const ResultValue& value) {
  const std::string line = encode_result(Id::number(1), value);
  constexpr std::string_view kBefore = R"({"jsonrpc":"2.0","id":1,"result":)";
  EXPECT_THAT(line, testing::StartsWith(std::string(kBefore)));
  return line.substr(kBefore.size(), line.size() - kBefore.size() - 1);
}

TEST(Results, StatusIsTheNormativeObject) {
  EXPECT_EQ(result_of(example_status()), kExampleStatus);
  EXPECT_EQ(*decode_result<Status>(kExampleStatus), example_status());
}

TEST(Results, UnknownReadingsAreNull) {
  Status s = example_status();
  s.temperature_c.sensor.reset();
  s.orientation.reset();
  s.fan.speed_rpm.reset();
  const std::string text = result_of(s);
  EXPECT_THAT(text, HasSubstr(R"("sensor":null)"));
  EXPECT_THAT(text, HasSubstr(R"("orientation":null)"));
  EXPECT_EQ(*decode_result<Status>(text), s);
}

TEST(Results, NumbersAreRoundedAndNeverNegativeZeroNorNaN) {
  Status s = example_status();
  s.current_a = {-0.0001, 4.98765, -4.126};
  s.force_n = 0.0628499;
  s.limit_a = std::numeric_limits<double>::infinity();
  const std::string text = result_of(s);
  EXPECT_THAT(text, HasSubstr(R"("current_a":[0,4.988,-4.126])"));
  EXPECT_THAT(text, HasSubstr(R"("force_n":0.0628,)"));
  EXPECT_THAT(text, HasSubstr(R"("limit_a":null,)"));
}

TEST(Results, PinsOnlyWhenThereAreSome) {
  Status s = example_status();
  EXPECT_THAT(result_of(s), testing::Not(HasSubstr("\"pins\"")));
  s.pins = {{0.01234567, 0}, {0.2364, -0.0456}};
  EXPECT_THAT(result_of(s),
              HasSubstr(R"("pins":{"force_n":[0.0123,0],"extension_mm":[0.236,-0.046]}})"));
}

TEST(Results, Admission) {
  Admission a{41, std::nullopt, true, std::nullopt, 9.3, 0.115, 34, 21.4, 9120, std::nullopt};
  EXPECT_EQ(result_of(a),
            R"({"effect":41,"accepted":true,"limited_by":null,"current_a":9.3,"force_n":0.115,)"
            R"("pin":34,"headroom_s":21.4,"seq":9120})");
  a.slot = "engine";
  a.limited_by = "thermal";
  a.headroom_s.reset();
  a.period_ms = 1500;
  EXPECT_EQ(result_of(a),
            R"({"effect":41,"slot":"engine","accepted":true,"limited_by":"thermal",)"
            R"("current_a":9.3,"force_n":0.115,"pin":34,"headroom_s":null,"seq":9120,)"
            R"("period_ms":1500})");
  EXPECT_EQ(*decode_result<Admission>(result_of(a)), a);
}

TEST(Results, HelloListsTheMethodsOfTheTable) {
  HelloResult hello;
  hello.version = "1.0.0";
  hello.connection = 7;
  hello.role = Role::kPlay;
  hello.state = "armed";
  hello.device = {"ball-7", "hedgehog-86", true};
  const HelloResult read = *decode_result<HelloResult>(result_of(hello));
  ASSERT_EQ(read.methods.size(), kMethods.size());
  EXPECT_EQ(read.methods.front(), "connection.list");
  EXPECT_EQ(read.role, Role::kPlay);
  EXPECT_EQ(read.device, hello.device);
  EXPECT_EQ(read.limits, hello.limits);
  EXPECT_THAT(result_of(hello), HasSubstr(R"("limits":{"current_a":15,"continuous_a":5,)"
                                          R"("felt_a":2.1,"duration_ms":10000,"lease_ms":10000,)"
                                          R"("effects":32,"frequency_hz":250,"telemetry_hz":200,)"
                                          R"("line_bytes":65536}})"));
}

TEST(Results, TextIsEscapedAndAlwaysUtf8) {
  GainResult gain;
  StateResult state{"tripped", "a\"\\\n\x01ä", std::string("\xff") + "x\xc3", 1};
  EXPECT_EQ(result_of(state),
            "{\"state\":\"tripped\",\"reason\":\"a\\\"\\\\\\n\\u0001ä\","
            "\"remedy\":\"\uFFFDx\uFFFD\",\"seq\":1}");
  EXPECT_EQ(result_of(gain), R"({"gain":1,"seq":0})");
}

TEST(Results, EveryKindIsDecodedUnchanged) {
  const ConnectionsResult connections{
      {{3, "Racer", "tcp", "127.0.0.1:5", std::nullopt, std::nullopt, Role::kPlay, 12.5, false,
        example_status().effects},
       {4, std::nullopt, "unix", std::nullopt, 1000, 4711, Role::kOperate, 1.0, true, {}},
       {5, std::nullopt, "unix", std::nullopt, 0, std::nullopt, Role::kOperate, 1.0, false, {}}}};
  EXPECT_EQ(*decode_result<ConnectionsResult>(result_of(connections)), connections);
  const DevicesResult devices{
      {{"USB 1-3", "1209:0001", "Hedgehog driver board", "7", "1.02", "1.2", "board", std::nullopt},
       {"Bluetooth", "054c:0ce6", "Pad", std::nullopt, std::nullopt, std::nullopt, std::nullopt,
        "not asked for"}},
      {{"thermometer", "no TEMPer thermometer is connected"}},
      3};
  EXPECT_EQ(*decode_result<DevicesResult>(result_of(devices)), devices);
  const ForecastResult forecast{12.5, std::nullopt, 6.25, 40.0};
  EXPECT_EQ(*decode_result<ForecastResult>(result_of(forecast)), forecast);
  Description description;
  description.name = "ball-7";
  description.pins = {{0, {0, 0, 1}, 0, 0.0}, {1, {0.5, 0, 0.5}, 1, 0.522}};
  description.coils.matrix = {model::Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, -1}};
  description.coils.r25_ohm = {0.45, 0.46, 0.44};
  description.coils.measured = {{0.4512, 0.0027, -0.012}, {0.46, 0.0, std::nullopt}, {}};
  description.thermal = {{60, 58, 57}, 84, {1, 0.9, 1.1}, 1.8, 5, 2, 1.5};
  description.uncertainty = {0.06, 0.01, 0.5};
  description.limits = {14, 4, 2, 59, 66, 68, 69, 44};
  description.board = {"simulator", true, std::nullopt, "1.02", "1.2"};
  EXPECT_EQ(*decode_result<Description>(result_of(description)), description);
  EXPECT_EQ(decode_result<Description>("{}")->limits.current_a, 0.0);
  for (const auto& [sent, winding] : {std::pair{"9", 2}, {"-1", 0}, {"1099511627776", 2}, {"1", 1}})
    EXPECT_EQ(
        decode_result<Description>(std::string(R"({"thermal":{"sensor_winding":)") + sent + "}}")
            ->thermal.sensor_winding,
        winding);
  TelemetryResult telemetry{100.0, {}};
  telemetry.fields.add(StatusKey::kOrientation);
  EXPECT_EQ(result_of(telemetry), R"({"rate_hz":100,"fields":["orientation"]})");
  EXPECT_EQ(*decode_result<TelemetryResult>(result_of(telemetry)), telemetry);
  const EventsResult events{"armed", std::nullopt, true, 9.31};
  EXPECT_EQ(*decode_result<EventsResult>(result_of(events)), events);
  const SimResult sim{25, {"fan_stopped"}, 1, {{"pwm_stuck", 2, 0.3, 0.0}}};
  const SimTruthResult truth{{60, 30, 30}, 40, 35, {5, 0, -1}, 25};
  EXPECT_EQ(*decode_result<SimTruthResult>(result_of(truth)), truth);
  EXPECT_EQ(*decode_result<SimResult>(result_of(sim)), sim);
  EXPECT_EQ(*decode_result<StopResult>(result_of(StopResult{3, 9160})), (StopResult{3, 9160}));
  EXPECT_EQ(*decode_result<ClaimResult>(result_of(ClaimResult{500})), ClaimResult{500});
  EXPECT_EQ(*decode_result<RecenterResult>(result_of(RecenterResult{-53.2})),
            RecenterResult{-53.2});
}

TEST(Results, ClientsIgnoreUnknownMembers) {
  const Result<Admission> a =
      decode_result<Admission>(R"({"effect":41,"seq":3,"new_in_1_4":{"x":[]},"slot":null})");
  ASSERT_TRUE(a.has_value());
  EXPECT_EQ(a->effect, 41u);
  EXPECT_EQ(a->slot, std::nullopt);
  EXPECT_EQ(a->pin, 0);
  EXPECT_THAT(decode_result<Admission>(R"({"effect":"41"})").error().message, HasSubstr("effect"));
  EXPECT_FALSE(decode_result<Admission>("[]").has_value());
  EXPECT_FALSE(decode_result<Admission>("{").has_value());
  EXPECT_EQ(decode_result<HelloResult>(R"({"role":"emperor"})")->role, Role::kObserve);
}

TEST(Notifications, TelemetryHasTheRequestedKeysAndTheTime) {
  Telemetry t{{}, example_status()};
  t.keys.add(StatusKey::kOrientation);
  const std::string line = encode_telemetry(t);
  EXPECT_EQ(line, R"({"jsonrpc":"2.0","method":"telemetry","params":{"time_ns":273660123456789,)"
                  R"("orientation":{"quaternion":{"w":0.994,"x":-0.105,"y":0.035,"z":0},)"
                  R"("up":[-0.069,-0.208,0.976],"rate_deg_s":[0.1,0,0],"age_ms":3}}})");
  const auto messages = *decode_messages(line);
  const auto& read = std::get<TelemetryMessage>(messages.at(0)).telemetry;
  EXPECT_TRUE(read.keys.contains(StatusKey::kOrientation));
  EXPECT_TRUE(read.keys.contains(StatusKey::kTimeNs));
  EXPECT_FALSE(read.keys.contains(StatusKey::kState));
  EXPECT_EQ(read.status.orientation, example_status().orientation);
  EXPECT_LT(line.size(), 240u) << "100 a second should stay near 22 kB/s";
}

TEST(Notifications, EventsCarryOnlyTheirOwnFields) {
  Event started;
  started.type = "effect_started";
  started.time_ns = 5;
  started.effect = 41;
  started.seq = 9120;
  EXPECT_EQ(encode_event(started),
            R"({"jsonrpc":"2.0","method":"event","params":{"type":"effect_started","time_ns":5,)"
            R"("effect":41,"slot":null,"seq":9120}})");
  Event ended;
  ended.type = "effect_ended";
  ended.effect = 41;
  ended.slot = "engine";
  ended.reason = "completed";
  ended.onset_ns = 1;
  ended.offset_ns = 2;
  ended.delivered = EventDelivery{0.9, 0.95};
  ended.masked_ms = 0;
  ended.mixed_ms = 3;
  EXPECT_EQ(encode_event(ended),
            R"({"jsonrpc":"2.0","method":"event","params":{"type":"effect_ended","time_ns":0,)"
            R"("effect":41,"slot":"engine","reason":"completed","onset_ns":1,"offset_ns":2,)"
            R"("delivered":{"min":0.9,"mean":0.95},"masked_ms":0,"mixed_ms":3}})");
  Event state;
  state.type = "state_changed";
  state.state = "armed";
  EXPECT_EQ(encode_event(state),
            R"({"jsonrpc":"2.0","method":"event","params":{"type":"state_changed","time_ns":0,)"
            R"("state":"armed","reason":null,"remedy":null}})");
  Event lost;
  lost.type = "orientation_lost";
  EXPECT_EQ(
      encode_event(lost),
      R"({"jsonrpc":"2.0","method":"event","params":{"type":"orientation_lost","time_ns":0}})");
  for (const Event& event : {started, ended, state, lost}) {
    const auto messages = *decode_messages(encode_event(event));
    EXPECT_EQ(std::get<EventMessage>(messages.at(0)).event, event) << event.type;
  }
}

}  // namespace
}  // namespace hedgehog::protocol
