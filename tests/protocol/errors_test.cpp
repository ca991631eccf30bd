// SPDX-License-Identifier: MIT
// Errors: a sentence for a person, `data.name` and the rest for a program.
#include "protocol/client_codec.h"
#include "tests/protocol/decoding.h"

namespace hedgehog::protocol {
namespace {

std::string line_for(const RpcError& error) { return encode_error(Id::number(12), error); }

TEST(Errors, OutOfRange) {
  EXPECT_EQ(line_for(out_of_range("level", 1, 1.4)),
            R"({"jsonrpc":"2.0","id":12,"error":{"code":-32602,"message":"level: 1.4 is above 1",)"
            R"("data":{"name":"invalid_params","field":"level","limit":1,"value":1.4}}})");
  EXPECT_EQ(out_of_range("lease_ms", 100, 99).message, "lease_ms: 99 is below 100");
}

TEST(Errors, NotArmedHasReasonAndRemedy) {
  EXPECT_EQ(line_for(not_armed("tripped", "sensor_frozen", "Run: hedgehogctl arm")),
            R"({"jsonrpc":"2.0","id":12,"error":{"code":-32000,)"
            R"("message":"not_armed: the ball is tripped (sensor_frozen). Run: hedgehogctl arm",)"
            R"("data":{"name":"not_armed","state":"tripped","reason":"sensor_frozen",)"
            R"("remedy":"Run: hedgehogctl arm","role_needed":"operate"}}})");
}

TEST(Errors, Forbidden) {
  EXPECT_EQ(line_for(forbidden("scope", "all", Role::kOperate, Role::kPlay)),
            R"({"jsonrpc":"2.0","id":12,"error":{"code":-32004,)"
            R"("message":"scope: all needs the role operate, you have play",)"
            R"("data":{"name":"forbidden","field":"scope","role_needed":"operate"}}})");
}

TEST(Errors, TheOthers) {
  EXPECT_EQ(no_such_effect(41).message, "effect: you play no effect 41");
  EXPECT_EQ(no_such_slot("x").value, ErrorValue{"x"});
  EXPECT_EQ(busy("the queue is full", 1).retry_after_ms, 1);
  EXPECT_EQ(device_absent("frame", "world needs an orientation sensor", "imu").device, "imu");
}

TEST(Errors, EveryCodeHasItsNameAndNumber) {
  const std::vector<std::pair<int, std::string>> documented{{-32700, "parse_error"},
                                                            {-32600, "invalid_request"},
                                                            {-32601, "method_not_found"},
                                                            {-32602, "invalid_params"},
                                                            {-32603, "internal_error"},
                                                            {-32000, "not_armed"},
                                                            {-32001, "busy"},
                                                            {-32002, "no_such_effect"},
                                                            {-32003, "unauthorized"},
                                                            {-32004, "forbidden"},
                                                            {-32005, "device_absent"},
                                                            {-32006, "unsupported"},
                                                            {-32007, "refused_thermal"},
                                                            {-32008, "no_such_pattern"},
                                                            {-32009, "claimed"},
                                                            {-32010, "armed"}};
  for (const auto& [code, text] : documented) EXPECT_EQ(name(static_cast<ErrorCode>(code)), text);
  ASSERT_EQ(kErrorCodes.size(), documented.size());
  for (std::size_t i = 0; i < documented.size(); ++i)
    EXPECT_EQ(static_cast<int>(kErrorCodes[i]), documented[i].first);
}

TEST(Errors, ClientsDecodeThemCompletely) {
  RpcError error = not_armed("disarmed", "unclean_stop", "Run: hedgehogctl arm");
  error.code = ErrorCode::kRefusedThermal;
  error.field = "level";
  error.limit = 0.62;
  error.value = std::string("much");
  error.retry_after_ms = 11'000;
  error.device = "imu";
  error.limit_a = 9.3;
  const auto messages = *decode_messages(line_for(error));
  const Reply& reply = std::get<Reply>(messages.at(0));
  EXPECT_EQ(reply.id, Id::number(12));
  EXPECT_EQ(reply.result.error(), error);
}

TEST(Client, KeepsTheResultUnchanged) {
  const auto messages =
      *decode_messages(R"({"jsonrpc":"2.0","id":3,"result":{"b":1,"a":[1.5,null,"ä"]}})");
  EXPECT_EQ(*std::get<Reply>(messages.at(0)).result, R"({"b":1,"a":[1.5,null,"ä"]})");
}

TEST(Client, ReadsBatchesAndSkipsUnknownItems) {
  const auto messages = *decode_messages(
      R"([{"jsonrpc":"2.0","id":1,"result":{}},{"jsonrpc":"2.0","method":"news","params":{}}])");
  ASSERT_EQ(messages.size(), 2u);
  EXPECT_EQ(std::get<UnknownMessage>(messages[1]).method, "news");
  EXPECT_TRUE(std::holds_alternative<EventMessage>(
      decode_messages(R"({"jsonrpc":"2.0","method":"event","params":{"type":"comet"}})")->at(0)));
}

TEST(Client, InvalidResponsesAreErrors) {
  for (const std::string line : {"", "HTTP/1.1 400", "{}", "[1]", R"({"id":1})",
                                 R"({"method":"event","params":{"type":5}})"})
    EXPECT_FALSE(decode_messages(line).has_value()) << line;
  // an error without its members is still an error
  const auto bare = *decode_messages(R"({"id":1,"error":{}})");
  EXPECT_FALSE(std::get<Reply>(bare.at(0)).result.has_value());
}

TEST(Client, RawRequestsAreForwarded) {
  EXPECT_EQ(encode_raw_request(Id::number(1), "x.y", R"({"a":1})"),
            R"({"jsonrpc":"2.0","id":1,"method":"x.y","params":{"a":1}})");
  EXPECT_EQ(encode_request(std::nullopt, EffectStopAll{}),
            R"({"jsonrpc":"2.0","method":"effect.stop_all","params":{"scope":"mine"}})");
  EXPECT_EQ(encode_request(Id::number(2), DeviceArm{}),
            R"({"jsonrpc":"2.0","id":2,"method":"device.arm"})");
}

}  // namespace
}  // namespace hedgehog::protocol
