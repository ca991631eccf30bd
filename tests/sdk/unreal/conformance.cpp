// SPDX-License-Identifier: MIT
// Runs the case of conformance.json in HEDGEHOG_CASE on the plugin's core with the plugin's own
// transport. Prints "passed", or the difference. Exit: 0 passed, 1 not.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <deque>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "clients/unreal/Source/HedgehogHaptics/Private/core/client.h"
#include "clients/unreal/Source/HedgehogHaptics/Private/socket_transport.h"
#include "tests/sdk/unreal/engine_stub.h"

namespace {

using namespace hedgehog::unreal;

class Player {
 public:
  explicit Player(const char* timeout)
      : client_(
            {.address = {}, .name = "conformance", .timeout_s = std::atof(timeout), .token = {}},
            HedgehogConnector(), listeners()) {}

  void play(const Json& steps) {
    const bool opens = steps.items().front()["open"].truth();
    if (!opens) {
      wait_until([this] { return client_.is_open() || !ended_.empty(); });
      check(client_.is_open(), ended_);
    }
    for (const Json& step : steps.items()) {
      const double began_s = FPlatformTime::Seconds();
      take(step);
      check(FPlatformTime::Seconds() - began_s >= step["at_least_s"].number(), "too early");
    }
    client_.close();
  }

 private:
  Listeners listeners() {
    Listeners all;
    all.connected = [this](const Json&) { ++connections_; };
    all.disconnected = [this](const std::string& reason) { ended_ = reason; };
    all.notification = [this](const std::string& method, const Json& params) {
      notifications_.emplace_back(method, params);
    };
    all.subscription_ended = [this](const std::string& method, const Answer& refusal) {
      subscriptions_ended_.emplace_back(method + ": " + refusal.message);
      if (!asked_when_ended_.empty()) request(asked_when_ended_, Json::object());
    };
    return all;
  }

  void take(const Json& step) {
    const Json& params = step["params"].fields().empty() ? Json::object() : step["params"];
    if (step["notification"].is(Json::Kind::kString)) {
      wait_until([this] { return !notifications_.empty(); });
      const auto [method, received] = notifications_.front();
      notifications_.pop_front();
      check(method == step["notification"].text() && received == step["params"], method);
    } else if (step["reconnected"].is(Json::Kind::kNumber)) {
      check(connections_ - 1 == step["reconnected"].number(), "connected more or less often");
    } else if (step["ask"].is(Json::Kind::kString)) {
      request(step["ask"].text(), params);
    } else if (step["ask_when_ended"].is(Json::Kind::kString)) {
      asked_when_ended_ = step["ask_when_ended"].text();
    } else if (step["flood"].is(Json::Kind::kString)) {
      flood(step["flood"].text());
    } else if (step["rumble_again"].is(Json::Kind::kString)) {
      wait_until([this, &step] {
        return client_.rumble(step["rumble_again"].text(), step["strength"].number(), Json());
      });
    } else if (step["answered"].truth()) {
      wait_until([this] { return asked_.has_value(); });
      check_outcome(step, *asked_);
    } else if (step["subscriptions_ended"].is(Json::Kind::kArray)) {
      check(Json::array(subscriptions_ended_) == step["subscriptions_ended"], "others have ended");
    } else if (step["notify"].is(Json::Kind::kString)) {
      check(client_.notify(step["notify"].text(), params), "not sent");
    } else if (step["rumble"].is(Json::Kind::kString)) {
      check(client_.rumble(step["rumble"].text(), step["strength"].number(), step["direction"],
                           params),
            "not sent");
    } else if (step["not_finite"].is(Json::Kind::kString)) {
      Json given = params;
      given.set(step["not_finite"].text(), std::nan(""));
      check(ask(step["call"].text(), given).failure == Failure::kBadValue, "another failure");
    } else if (step["call_again"].is(Json::Kind::kString)) {
      Answer answer = ask(step["call_again"].text(), params);
      while (answer.failure == Failure::kNotConnected) {
        const double until_s = FPlatformTime::Seconds() + answer.retry_after_s;
        wait_until([until_s] { return FPlatformTime::Seconds() >= until_s; });
        answer = ask(step["call_again"].text(), params);
      }
      check(answer.result == step["result"], answer.message);
    } else {
      // The client opens the connection by itself; any request waits until hello is answered.
      const bool open = step["open"].truth();
      check_outcome(step, ask(open ? "ping" : step["call"].text(), params));
    }
  }

  void check_outcome(const Json& step, const Answer& answer) {
    const Json& error = step["error"];
    if (step["failure"].is(Json::Kind::kString)) {
      check(answer.failure == Failure::kNotConnected, "another failure: " + answer.message);
      check(answer.message.find(step["says"].text()) != std::string::npos, answer.message);
      const auto& retry_s = step["retry_s"].items();
      check(retry_s.empty() || (answer.retry_after_s >= retry_s[0].number() &&
                                answer.retry_after_s <= retry_s[1].number()),
            "another time to retry: " + std::to_string(answer.retry_after_s));
    } else if (error.is(Json::Kind::kObject)) {
      check(answer.failure == Failure::kRefused && answer.code == error["code"].number() &&
                answer.name == error["name"].text() && answer.message == error["message"].text() &&
                answer.data["field"] == error["field"],
            answer.message);
    } else {
      check(answer.ok(), answer.message);
      check(step["result"].is(Json::Kind::kNull) || answer.result == step["result"],
            answer.result.to_text());
    }
  }

  void request(const std::string& method, const Json& params) {
    client_.request(
        method, params, [this](const Answer& answer) { asked_ = answer; });
  }

  /// Far more than what the kernel and the core keep, in lines shorter than 64 KiB.
  void flood(const std::string& method) {
    const Json params = Json::object({{"text", std::string(30'000, 'x')}});
    for (int line = 0; line < 2000; ++line)
      if (!client_.notify(method, params)) return;
    check(false, "what the daemon does not read is kept");
  }

  Answer ask(const std::string& method, const Json& params) {
    std::optional<Answer> came;
    client_.request(
        method, params, [&came](const Answer& answer) { came = answer; });
    wait_until([&came] { return came.has_value(); });
    return *came;
  }

  template <class Done>
  void wait_until(Done done) {
    while (!done()) {
      client_.poll(FPlatformTime::Seconds());
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
  }

  static void check(bool holds, const std::string& otherwise) {
    if (holds) return;
    std::printf("%s\n", otherwise.c_str());
    std::exit(1);
  }

  int connections_ = 0;
  std::string ended_;
  std::optional<Answer> asked_;
  std::string asked_when_ended_;
  std::vector<Json> subscriptions_ended_;
  std::deque<std::pair<std::string, Json>> notifications_;
  Client client_;
};

/// The parser must reject numbers beyond the range of a double, and read others.
bool reads_numbers() {
  const auto number = [](const char* text) {
    const auto read = Json::parse(text);
    return read ? read->number() : -1.0;
  };
  return number("1e999") == -1.0 && number("0e999") == 0.0 && number("2.5e-1") == 0.25 &&
         number("15e1") == 150.0;
}

}  // namespace

int main() {
  if (!reads_numbers()) {
    std::puts("numbers are read wrongly");
    return 1;
  }
  const char* const text = std::getenv("HEDGEHOG_CASE");
  const char* const timeout = std::getenv("HEDGEHOG_TIMEOUT_S");
  const auto one = Json::parse(text != nullptr ? text : "");
  if (!one || timeout == nullptr) return 64;
  Player(timeout).play((*one)["client"]);
  std::puts("passed");
  return 0;
}
