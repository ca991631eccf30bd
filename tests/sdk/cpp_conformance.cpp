// SPDX-License-Identifier: MIT
// Runs conformance.json on the C++ library, with and without a thread: cpp_conformance FOLDER.
// Exit: 0 all cases pass.
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>

#include "tests/sdk/cpp_libraries.h"

namespace hedgehog {
namespace {

using nlohmann::json;

void expect(bool holds, const std::string& what) {
  if (!holds) throw std::runtime_error("not so: " + what);
}

/// The parameters as text, without null members; empty if there are none.
std::string text_of(json params) {
  for (auto it = params.begin(); it != params.end();)
    it = it->is_null() ? params.erase(it) : std::next(it);
  return params.empty() ? "" : params.dump();
}

/// The daemon's side of a case, as a separate process.
class FakeDaemon {
 public:
  FakeDaemon(const std::string& folder, const std::string& name, const json& environment)
      : pipe_(::popen(("python3 '" + folder + "/fake_daemon.py' \"" + name + "\"").c_str(), "r")) {
    char port[16] = {};
    expect(pipe_ != nullptr && std::fgets(port, sizeof port, pipe_) != nullptr, "a port");
    const auto variables = [&environment](const std::string& name) -> std::optional<std::string> {
      if (!environment.contains(name)) return std::nullopt;
      return environment[name].get<std::string>();
    };
    address_ = client::daemon_addresses("127.0.0.1:" + std::to_string(std::atoi(port)), variables)
                   .value()
                   .front();
  }
  FakeDaemon(const FakeDaemon&) = delete;
  FakeDaemon& operator=(const FakeDaemon&) = delete;
  ~FakeDaemon() { finish(); }

  const client::Address& address() const { return address_; }
  bool finish() {
    const int status = pipe_ == nullptr ? 0 : ::pclose(pipe_);
    pipe_ = nullptr;
    return status == 0;
  }

 private:
  std::FILE* pipe_;
  client::Address address_;
};

/// Checks the outcome against the step; throws when it differs.
void check(const json& step, const client::Outcome<std::string>& outcome) {
  if (step.contains("failure")) {
    expect(!outcome && outcome.error().failure != Failure::kRefused, "not connected");
    expect(outcome.error().message.find(step["says"].get<std::string>()) != std::string::npos,
           outcome.error().message);
  } else if (step.contains("error")) {
    expect(!outcome && outcome.error().refusal, "refused");
    const json& expected = step["error"];
    const protocol::RpcError refusal = *outcome.error().refusal;
    expect(static_cast<int>(refusal.code) == expected["code"], "the code");
    // This library derives the name from the code, even when the daemon sends none.
    expect(expected["name"] == "" || expected["name"] == std::string(protocol::name(refusal.code)),
           "the name");
    expect(expected["message"] == outcome.error().message, "the message");
    expect(expected.value("field", "") == refusal.field.value_or(""), "the field");
  } else {
    expect(outcome.has_value(), outcome ? "" : outcome.error().message);
    if (step.contains("result")) expect(json::parse(*outcome) == step["result"], *outcome);
  }
}

protocol::EffectParams effect_params(const json& params) {
  protocol::EffectParams made;
  for (const auto& [name, value] : params.items()) {
    expect(name == "frequency_hz", "a parameter that this program does not know: " + name);
    made.frequency_hz = value.get<double>();
  }
  return made;
}

/// Far more than what the kernel and the library keep, in lines shorter than 64 KiB.
template <class Library>
void flood(Library& library, const std::string& method) {
  const std::string params = json{{"text", std::string(30'000, 'x')}}.dump();
  for (int line = 0; line < 2000; ++line)
    if (!library.notify(method, params)) return;
  expect(false, "a connection that has ended");
}

/// `ended`: the ended subscriptions reported so far.
template <class Library>
void play(Library& library, const json& step, json& ended) {
  const json params = step.value("params", json::object());
  if (step.contains("call")) {
    check(step, library.call(step["call"], text_of(params)));
  } else if (step.contains("call_again")) {
    auto outcome = library.call(step["call_again"], "");
    for (; !outcome; outcome = library.call(step["call_again"], ""))
      std::this_thread::sleep_for(library.retry_after());
    check(step, outcome);
  } else if (step.contains("ask")) {
    expect(library.request(step["ask"]), "asked");
  } else if (step.contains("answered")) {
    check(step, library.response());
  } else if (step.contains("flood")) {
    flood(library, step["flood"]);
  } else if (step.contains("rumble_again")) {
    while (!library.rumble(step["rumble_again"], step["strength"], std::nullopt, {}))
      std::this_thread::sleep_for(library.retry_after());
  } else if (step.contains("subscriptions_ended")) {
    const json& expected = step["subscriptions_ended"];
    // The library's thread may have read a refusal that it has not reported yet.
    const auto deadline = std::chrono::steady_clock::now() + kTimeout;
    do {
      while (const auto refused = library.refused_renewal()) ended.push_back(refused->message);
    } while (ended.size() < expected.size() && std::chrono::steady_clock::now() < deadline);
    expect(ended == expected, ended.dump());
  } else if (step.contains("notify")) {
    expect(library.notify(step["notify"], text_of(params)), "notified");
  } else if (step.contains("rumble")) {
    std::optional<protocol::Direction> direction;
    if (step.value("direction", "") == "back") direction = protocol::Word::kBack;
    expect(library.rumble(step["rumble"], step["strength"], direction, effect_params(params)),
           "rumbled");
  } else if (step.contains("reconnected")) {
    expect(library.connections() - 1 == step["reconnected"], "another number of connections");
  } else {
    const auto received = library.next();
    const auto& event = std::get<protocol::EventMessage>(received);
    expect(step["notification"] == "event" && json::parse(event.json) == params, event.json);
  }
}

template <class Library>
void check_opened(Library& library, const json& step, const client::Outcome<void>& opened) {
  check(step, opened ? client::Outcome<std::string>(std::string()) : opened.error());
  if (!step.contains("retry_s")) return;
  const double retry_s = std::chrono::duration<double>(library.retry_after()).count();
  expect(retry_s >= step["retry_s"][0] && retry_s <= step["retry_s"][1],
         std::to_string(retry_s) + " s");
}

template <class Library>
void play_case(const std::string& folder, const json& one) {
  const std::string name = one["name"];
  FakeDaemon daemon(folder, name, one.value("environment", json::object()));
  const Milliseconds timeout{one.contains("timeout_s") ? 1000 * one["timeout_s"].get<int>()
                                                       : kTimeout.count()};
  {
    Library library(daemon.address(), {.name = "conformance", .timeout = timeout});
    const auto opened = library.open();
    if (!one["client"][0].contains("open"))
      expect(opened.has_value(), opened ? "" : opened.error().message);
    json ended = json::array();
    for (const json& step : one["client"]) {
      const auto began = std::chrono::steady_clock::now();
      if (step.contains("open"))
        check_opened(library, step, opened);
      else
        play(library, step, ended);
      const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - began;
      expect(taken.count() >= step.value("at_least_s", 0.0), "too early");
    }
  }
  expect(daemon.finish(), "what the daemon expects");
}

/// Prints a line on the terminal, and writes one for the table of run.sh.
template <class Library>
bool run(const std::string& folder, const json& one) {
  const std::string name = one["name"];
  for (const json& apart : one.value("without", json::array()))
    if (apart == Library::kName) return true;
  std::string wrong;
  try {
    play_case<Library>(folder, one);
  } catch (const std::exception& error) {
    wrong = error.what();
  }
  std::printf("%s%s: %s%s\n", wrong.empty() ? "ok      " : "FAILED  ", Library::kName, name.c_str(),
              wrong.empty() ? "" : (": " + wrong).c_str());
  if (const char* table = std::getenv("HEDGEHOG_CONFORMANCE_TABLE")) {
    std::ofstream(table, std::ios::app)
        << Library::kName << '\t' << name << '\t' << (wrong.empty() ? "ok" : "failed") << '\n';
  }
  return wrong.empty();
}

int run_all(const std::string& folder) {
  const json cases = json::parse(std::ifstream(folder + "/conformance.json")).at("cases");
  bool well = true;
  for (const json& one : cases) {
    well = run<Waiting>(folder, one) && well;
    well = run<Frames>(folder, one) && well;
    well = run<Threaded>(folder, one) && well;
  }
  return well ? 0 : 1;
}

}  // namespace
}  // namespace hedgehog

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("cpp_conformance FOLDER\n", stderr);
    return 64;
  }
  return hedgehog::run_all(arguments[1]);
}
