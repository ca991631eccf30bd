// SPDX-License-Identifier: MIT
// JSON-RPC 2.0 around the requests: ids, batches, notifications, and invalid lines.
#include "tests/protocol/decoding.h"

namespace hedgehog::protocol {
namespace {

using testing::HasSubstr;

TEST(Envelope, IdIsReturnedUnchanged) {
  for (const std::string id : {"7", "-3", "0", "\"abc\"", "\"\"", "null", "1.5", "9007199254740992",
                               "-9007199254740992", "\"\\u00e4\""}) {
    const Item item = only(R"({"jsonrpc":"2.0","id":)" + id + R"(,"method":"ping"})");
    ASSERT_TRUE(item.id.has_value()) << id;
    EXPECT_TRUE(item.request.has_value());
    if (id != "\"\\u00e4\"")
      EXPECT_EQ(item.id->json, id);
    else
      EXPECT_EQ(item.id->json, "\"ä\"");
  }
}

TEST(Envelope, IdOfAnotherKindIsAnInvalidRequest) {
  for (const std::string id : {"true", "{}", "[1]", "1e300", "36893488147419103232",
                               "9007199254740993", "-9007199254740993", "9223372036854775807"}) {
    const RpcError error = refused_line(R"({"jsonrpc":"2.0","id":)" + id + R"(,"method":"ping"})");
    EXPECT_EQ(error.code, ErrorCode::kInvalidRequest) << id;
  }
}

TEST(Envelope, WithoutIdThereIsNoResponse) {
  EXPECT_EQ(only(R"({"jsonrpc":"2.0","method":"ping"})").id, std::nullopt);
  // an invalid notification has no response either
  EXPECT_EQ(only(R"({"jsonrpc":"2.0","method":"no.such"})").id, std::nullopt);
  EXPECT_EQ(only(R"({"jsonrpc":"2.0","method":"ping","params":{"x":1}})").id, std::nullopt);
}

TEST(Envelope, MethodIsReportedEvenWhenParametersAreWrong) {
  EXPECT_EQ(only(line_of("effect.pulse", R"({"level":3})")).method, method_named("effect.pulse"));
  EXPECT_EQ(only(line_of("effect.nudge", "{}")).method, std::nullopt);
}

TEST(Envelope, ParametersMayBeOmittedButNotPositional) {
  EXPECT_TRUE(only(R"({"jsonrpc":"2.0","id":1,"method":"device.status"})").request.has_value());
  EXPECT_EQ(refused("ping", "[]").code, ErrorCode::kInvalidParams);
  EXPECT_EQ(refused("ping", "null").field, "params");
  EXPECT_EQ(refused("ping", "3").code, ErrorCode::kInvalidParams);
}

TEST(Envelope, InvalidJsonIsAParseError) {
  for (const std::string line :
       {"",
        " ",
        "{",
        "}",
        "{\"a\":}",
        "nonsense",
        "{\"jsonrpc\":\"2.0\"",
        "{} {}",
        "[1,]",
        "NaN",
        "[NaN]",
        "[Infinity]",
        "[1e999]",
        "[-1e999]",
        "{'a':1}",
        "[01]",
        "\"\xff\"",
        "[\"\xc3\"]",
        "[\"\xed\xa0\x80\"]",
        "POST /ws HTTP/1.1",
        "{\"a\":1,\"a\":2}",
        "{\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\",\"params\":{\"x\":1,\"x\":1}}"})
    EXPECT_EQ(refused_line(line).code, ErrorCode::kParseError) << line;
}

TEST(Envelope, AParseErrorHasThePosition) {
  EXPECT_THAT(refused_line(R"({"jsonrpc":"2.0",)").message, HasSubstr("at byte "));
  EXPECT_THAT(refused_line("[1e999]").message, HasSubstr("too large"));
  EXPECT_THAT(refused_line(R"({"level":1,"level":0})").message, HasSubstr("'level' occurs twice"));
}

TEST(Envelope, NestingIsBoundedHoweverLongTheLine) {
  const auto nested = [](std::size_t depth) {
    return std::string(depth, '[') + std::string(depth, ']');
  };
  EXPECT_EQ(refused_line(nested(kMaxNesting + 1)).code, ErrorCode::kParseError);
  EXPECT_THAT(refused_line(nested(kMaxLineBytes / 2)).message, HasSubstr("nested"));
  EXPECT_EQ(refused_line(std::string(kMaxLineBytes, '[')).code, ErrorCode::kParseError);
  std::string objects;
  for (int i = 0; i < 10'000; ++i) objects += "{\"a\":";
  EXPECT_EQ(refused_line(objects).code, ErrorCode::kParseError);
  // a batch with a list as its item: not too deep, but no request
  EXPECT_EQ(decode_line("[[]]").items.at(0).request.error().code, ErrorCode::kInvalidRequest);
}

TEST(Envelope, JsonThatIsNoRequestIsAnInvalidRequest) {
  for (const std::string line :
       {"null", "1", "\"ping\"", "true", "{}", R"({"method":"ping"})",
        R"({"jsonrpc":"1.0","method":"ping"})", R"({"jsonrpc":2.0,"method":"ping"})",
        R"({"jsonrpc":"2.0"})", R"({"jsonrpc":"2.0","method":5})",
        R"({"jsonrpc":"2.0","result":{}})"})
    EXPECT_EQ(refused_line(line).code, ErrorCode::kInvalidRequest) << line;
  const Item item = only(R"({"jsonrpc":"2.0","id":9,"method":5})");
  EXPECT_EQ(item.id, Id::number(9));
}

TEST(Envelope, BatchKeepsItsOrderWithValidAndInvalidItems) {
  const Incoming incoming = decode_line(
      R"([{"jsonrpc":"2.0","id":1,"method":"ping"},7,{"jsonrpc":"2.0","method":"device.status"},)"
      R"({"jsonrpc":"2.0","id":2,"method":"nothing"}])");
  EXPECT_TRUE(incoming.batch);
  ASSERT_EQ(incoming.items.size(), 4u);
  EXPECT_TRUE(std::holds_alternative<Ping>(*incoming.items[0].request));
  EXPECT_EQ(incoming.items[1].request.error().code, ErrorCode::kInvalidRequest);
  EXPECT_EQ(incoming.items[1].id, Id{});
  EXPECT_TRUE(std::holds_alternative<DeviceStatus>(*incoming.items[2].request));
  EXPECT_EQ(incoming.items[2].id, std::nullopt);
  EXPECT_EQ(incoming.items[3].request.error().code, ErrorCode::kMethodNotFound);
}

TEST(Envelope, BatchHasOneToSixtyFourRequests) {
  const auto batch_of = [](std::size_t count) {
    std::string line = "[";
    for (std::size_t i = 0; i < count; ++i) {
      line += i == 0 ? "" : ",";
      line += R"({"jsonrpc":"2.0","method":"ping"})";
    }
    return line + "]";
  };
  EXPECT_EQ(refused_line(batch_of(0)).code, ErrorCode::kInvalidRequest);
  EXPECT_EQ(decode_line(batch_of(1)).items.size(), 1u);
  EXPECT_TRUE(decode_line(batch_of(1)).batch);
  EXPECT_EQ(decode_line(batch_of(kMaxBatch)).items.size(), kMaxBatch);
  const RpcError error = refused_line(batch_of(kMaxBatch + 1));
  EXPECT_EQ(error.code, ErrorCode::kInvalidRequest);
  EXPECT_EQ(error.limit, ErrorValue{std::int64_t{64}});
}

TEST(Envelope, WhitespaceAndCarriageReturnAreHarmless) {
  EXPECT_TRUE(only("  {\"jsonrpc\":\"2.0\",\"id\":1,\"method\":\"ping\"}\r").request.has_value());
}

TEST(Envelope, EncodesResponsesOnOneLine) {
  EXPECT_EQ(encode_result(Id::number(4), PingResult{12}),
            R"({"jsonrpc":"2.0","id":4,"result":{"time_ns":12}})");
  EXPECT_EQ(encode_result(Id{"\"x\""}, Done{}), R"({"jsonrpc":"2.0","id":"x","result":{}})");
  EXPECT_EQ(encode_batch({}), "");
  EXPECT_EQ(encode_batch({"{}", "{}"}), "[{},{}]");
}

}  // namespace
}  // namespace hedgehog::protocol
