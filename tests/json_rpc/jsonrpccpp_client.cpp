// SPDX-License-Identifier: MIT
// jsonrpccpp_client SOCKET: tests Debian's libjson-rpc-cpp with the daemon on that Unix socket.
// Exit: 0 the responses are as expected. In C++14: the library's headers have exception
// specifications.
#include <jsonrpccpp/client.h>
#include <jsonrpccpp/client/connectors/unixdomainsocketclient.h>

#include <iostream>
#include <string>

namespace {

int failures = 0;

void expect(bool good, const std::string& what) {
  if (good) return;
  std::cerr << "jsonrpccpp_client: " << what << "\n";
  ++failures;
}

Json::Value named() { return Json::Value(Json::objectValue); }

/// Plays on when the library closes the connection, which it does after each response.
Json::Value pulse() {
  Json::Value params = named();
  params["direction"] = "left";
  params["current_a"] = 5;
  params["duration_ms"] = 50;
  params["on_close"] = "finish";
  return params;
}

int error_of(jsonrpc::Client& client, const std::string& method, const Json::Value& params) {
  try {
    client.CallMethod(method, params);
  } catch (const jsonrpc::JsonRpcException& error) {
    return error.GetCode();
  }
  return 0;
}

void calls(jsonrpc::Client& client) {
  Json::Value hello = named();
  hello["client"] = "libjson-rpc-cpp";
  expect(client.CallMethod("hello", hello)["limits"]["current_a"].asDouble() > 0, "hello");
  expect(client.CallMethod("ping", named())["time_ns"].asInt64() > 0, "ping");
  expect(client.CallMethod("effect.pulse", pulse())["accepted"].asBool(), "effect.pulse");
}

void errors(jsonrpc::Client& client) {
  Json::Value sideways = pulse();
  sideways["direction"] = "sideways";
  expect(error_of(client, "no.such", named()) == -32601, "an unknown method");
  expect(error_of(client, "effect.pulse", sideways) == -32602, "a wrong parameter");
  Json::Value by_position(Json::arrayValue);
  by_position.append("left");
  expect(error_of(client, "effect.pulse", by_position) == -32602, "parameters by position");
}

/// `effect.pulse` is a notification between two requests.
void batch(jsonrpc::Client& client) {
  jsonrpc::BatchCall requests;
  const int ping = requests.addCall("ping", named());
  requests.addCall("effect.pulse", pulse(), true);
  const int unknown = requests.addCall("no.such", named());
  jsonrpc::BatchResponse responses = client.CallProcedures(requests);
  expect(responses.getResult(ping)["time_ns"].asInt64() > 0, "ping in a batch");
  Json::Value id = unknown;
  expect(responses.getErrorCode(id) == -32601, "an unknown method in a batch");
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "jsonrpccpp_client SOCKET\n";
    return 64;
  }
  jsonrpc::UnixDomainSocketClient connector(argv[1]);
  jsonrpc::Client client(connector, jsonrpc::JSONRPC_CLIENT_V2);
  try {
    calls(client);
    errors(client);
    batch(client);
  } catch (const jsonrpc::JsonRpcException& error) {
    expect(false, error.what());
  }
  return failures == 0 ? 0 : 1;
}
