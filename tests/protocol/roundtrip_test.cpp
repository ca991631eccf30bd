// SPDX-License-Identifier: MIT
// Laws: the daemon decodes every encoded request to the same value, and any other input is at most
// rejected with a documented error.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "protocol/client_codec.h"
#include "protocol/server_codec.h"
#include "tests/protocol/random_request.h"

namespace hedgehog::protocol {
namespace {

RC_GTEST_PROP(Laws, EveryValidRequestIsDecodedUnchanged, ()) {
  const Request request = *random_request();
  const Id id = Id::number(*rc::gen::arbitrary<int>());
  const std::string line = encode_request(id, request);
  RC_LOG() << line;
  const Incoming incoming = decode_line(line);
  RC_ASSERT(incoming.items.size() == 1u);
  const Item& item = incoming.items.front();
  RC_ASSERT(item.id == id);
  if (!item.request) RC_FAIL(item.request.error().message);
  RC_ASSERT(*item.request == request);
  RC_ASSERT(item.method == method_of(request));
}

/// A request alone takes a shorter way than one in a batch.
void check_equal_in_a_batch(const std::string& line) {
  RC_LOG() << line;
  const Incoming alone = decode_line(line);
  const Incoming batch = decode_line('[' + line + ']');
  RC_ASSERT(alone.items.size() == 1u);
  RC_ASSERT(batch.items.size() == 1u);
  const Item& one = alone.items.front();
  const Item& other = batch.items.front();
  RC_ASSERT(one.id == other.id);
  RC_ASSERT(one.method == other.method);
  RC_ASSERT(one.request.has_value() == other.request.has_value());
  if (one.request) {
    RC_ASSERT(*one.request == *other.request);
    return;
  }
  RC_ASSERT(one.request.error().code == other.request.error().code);
  // That of a text that is not JSON has its position.
  if (one.request.error().code != ErrorCode::kParseError)
    RC_ASSERT(one.request.error().message == other.request.error().message);
}

RC_GTEST_PROP(Laws, ARequestAloneIsDecodedAsInABatch, ()) {
  check_equal_in_a_batch(encode_request(Id::number(*rc::gen::arbitrary<int>()), *random_request()));
}

const std::vector<std::string> kMembers{R"("jsonrpc":"2.0")",
                                        R"( "jsonrpc" : "2.0" )",
                                        R"("jsonrpc":2.0)",
                                        R"("jsonrpc":"1.0")",
                                        R"("method":"ping")",
                                        R"("method":"effect.pulse")",
                                        R"("method":"pi\u006eg")",
                                        R"("method":7)",
                                        R"("method":"nix")",
                                        R"("id":1)",
                                        R"("id":-0)",
                                        R"("id":1.0)",
                                        R"("id":"a")",
                                        R"("id":"\u00e4")",
                                        R"("id":null)",
                                        R"("id":[1])",
                                        R"("id":12345678901234567890)",
                                        R"("params":{})",
                                        R"("params":{"level":0.5,"direction":"left"})",
                                        R"("params":{"a":1,"a":2})",
                                        R"("params":[])",
                                        R"("params":null)",
                                        R"("params":{"direction":[1,0,0]})",
                                        R"("x":{"y":[true,false,null]})",
                                        R"("x":tru)",
                                        R"("ä":1)",
                                        R"("":0)"};

RC_GTEST_PROP(Laws, AnyMembersAloneAreDecodedAsInABatch, ()) {
  std::vector<std::string> members;
  if (*rc::gen::arbitrary<bool>())
    members = {R"("jsonrpc":"2.0")",
               *rc::gen::element<std::string>(R"("method":"ping")", R"("method":"nix")")};
  for (int left = *rc::gen::inRange(0, 5); left > 0; --left) {
    const auto at = *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(members) + 1);
    members.insert(members.begin() + at, *rc::gen::elementOf(kMembers));
  }
  std::string line = "{";
  for (const std::string& member : members) line += (line == "{" ? "" : ",") + member;
  check_equal_in_a_batch(line + *rc::gen::element<std::string>("}", "}", "} ", ",}", "}}"));
}

RC_GTEST_PROP(Laws, DecodingIsReproducible, ()) {
  const std::string line = encode_request(std::nullopt, *random_request());
  const Incoming first = decode_line(line);
  RC_ASSERT(encode_request(std::nullopt, *first.items.front().request) == line);
}

void check_response(const Incoming& incoming) {
  RC_ASSERT(!incoming.items.empty());
  RC_ASSERT(incoming.items.size() <= kMaxBatch);
  for (const Item& item : incoming.items) {
    if (item.request) continue;
    const RpcError& error = item.request.error();
    RC_ASSERT(name(error.code) != "server_error");
    RC_ASSERT(!error.message.empty());
    RC_ASSERT(error.message.size() < 600u);
    const std::string line = encode_error(item.id.value_or(Id{}), error);
    const auto responses = decode_messages(line);
    RC_ASSERT(responses.has_value());
    const Reply& reply = std::get<Reply>(responses->at(0));
    RC_ASSERT(!reply.result.has_value());
    // Compared as text: a double with an integral value comes back as an integer.
    RC_ASSERT(encode_error(reply.id, reply.result.error()) == line);
  }
}

RC_GTEST_PROP(Laws, ArbitraryBytesAreAnswered, (const std::string& bytes)) {
  check_response(decode_line(bytes));
}

RC_GTEST_PROP(Laws, ADamagedRequestIsAnswered, ()) {
  std::string line = encode_request(Id::number(1), *random_request());
  const int damages = *rc::gen::inRange(1, 5);
  for (int i = 0; i < damages; ++i) {
    const auto at = static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(line.size())));
    switch (*rc::gen::inRange(0, 3)) {
      case 0:
        line[at] = *rc::gen::arbitrary<char>();
        break;
      case 1:
        line.erase(at, 1);
        break;
      default:
        line.insert(at, *rc::gen::elementOf(std::vector<std::string>{
                            "{", "}", "[", "]", "\"", ",", ":", "1e308", "-", "null", "\\u0000"}));
    }
  }
  check_response(decode_line(line));
}

/// A random JSON value of limited depth.
std::string random_json(int depth) {
  switch (*rc::gen::inRange(0, depth > 0 ? 7 : 5)) {
    case 0:
      return "null";
    case 1:
      return "true";
    case 2:
      return std::to_string(*rc::gen::arbitrary<double>());
    case 3:
      return std::to_string(*rc::gen::arbitrary<std::int64_t>());
    case 4:
      return "\"" + *rc::gen::container<std::string>(rc::gen::inRange('a', 'z')) + "\"";
    case 5:
      return "[" + random_json(depth - 1) + "," + random_json(depth - 1) + "]";
    default:
      return "{\"pin\":" + random_json(depth - 1) + ",\"w\":" + random_json(depth - 1) + "}";
  }
}

RC_GTEST_PROP(Laws, AnyValueForAnyParameterIsAnswered, ()) {
  const Method method = random_method();
  std::string params = "{";
  for (const std::string& parameter : parameter_names(method)) {
    if (*rc::gen::inRange(0, 4) == 0) {
      params += params.size() > 1 ? "," : "";
      params += "\"" + parameter + "\":" + random_json(3);
    }
  }
  const std::string line = R"({"jsonrpc":"2.0","id":1,"method":")" + std::string(name(method)) +
                           R"(","params":)" + params + "}}";
  const Incoming incoming = decode_line(line);
  RC_ASSERT(incoming.items.front().method == method);
  check_response(incoming);
}

}  // namespace
}  // namespace hedgehog::protocol
