// SPDX-License-Identifier: MIT
// Every parameter of an effect is an option of the verb that plays it.
#include "clients/ctl/effect_options.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "clients/ctl/command_line.h"
#include "clients/ctl/verbs/play_verbs.h"
#include "protocol/methods.h"
#include "protocol/server_codec.h"

namespace hedgehog::client {
namespace {

using model::EffectMethod;
using testing::HasSubstr;

constexpr std::array kMethods{EffectMethod::kPulse, EffectMethod::kCircle, EffectMethod::kVibrate,
                              EffectMethod::kHold, EffectMethod::kPlay};

std::string verb_of(EffectMethod method) {
  const std::string name(protocol::name(method));
  return name.substr(name.find('.') + 1);
}

std::string help_of(const std::vector<std::string>& words) {
  std::vector<std::string> arguments{"hedgehogctl"};
  arguments.insert(arguments.end(), words.begin(), words.end());
  arguments.emplace_back("--help");
  std::vector<char*> argv;
  for (std::string& word : arguments) argv.push_back(word.data());
  testing::internal::CaptureStdout();
  const int code = run_command_line(static_cast<int>(argv.size()), argv.data());
  const std::string help = testing::internal::GetCapturedStdout();
  EXPECT_EQ(code, 0);
  return help;
}

/// A valid value of the option.
std::string sample(const EffectOption& option) {
  switch (option.type) {
    case protocol::FieldType::kEnumerator:
      return option.values.substr(0, option.values.find('|'));
    case protocol::FieldType::kDirection:
      return "0,1,0.5";
    case protocol::FieldType::kList:
      return R"([{"t_ms":5,"level":1}])";
    case protocol::FieldType::kNumber:
      return option.values == "NUMBER" ? "1" : option.values.substr(0, option.values.find(".."));
    default:
      return "1e3";
  }
}

/// The request as decoded by the daemon.
protocol::Incoming sent(const PlayOptions& options) {
  const auto params = play_params(options);
  EXPECT_TRUE(params) << params.error().message;
  return protocol::decode_line(fmt::format(
      R"({{"jsonrpc":"2.0","id":1,"method":"{}","params":{}}})", options.method, *params));
}

TEST(EffectOptions, HaveEveryParameterOfTheProtocol) {
  for (const EffectMethod method : kMethods) {
    const std::string help = help_of({verb_of(method)});
    const std::string preview = help_of({"preview", verb_of(method)});
    protocol::EffectStart start{.method = method};
    const auto parameters =
        protocol::list_fields([&](protocol::Fields& fields) { start.describe(fields); });
    EXPECT_GE(parameters.size(), 20u);
    for (const protocol::FieldInfo& parameter : parameters) {
      const std::string flag = flag_of(parameter.name);
      EXPECT_THAT(help, HasSubstr(flag)) << verb_of(method);
      EXPECT_THAT(preview, HasSubstr(flag)) << verb_of(method);
    }
    for (const EffectOption& option : effect_options(method))
      EXPECT_NE(option.help, "") << option.parameter << " is not explained";
  }
}

TEST(EffectOptions, ReachTheDaemonAsTheirType) {
  for (const EffectMethod method : kMethods) {
    for (const EffectOption& option : effect_options(method)) {
      SCOPED_TRACE(verb_of(method) + " " + option.flag);
      PlayOptions options{.method = std::string(protocol::name(method))};
      if (method == EffectMethod::kPulse || method == EffectMethod::kHold)
        options.direction = "left";
      if (method == EffectMethod::kPlay && option.parameter != "keyframes")
        options.pattern = "heartbeat";
      // A hold has a lease, which excludes a duration.
      if (method == EffectMethod::kHold && option.parameter == "duration_ms") continue;
      if (option.parameter == "direction" || option.parameter == "rotate_to")
        options.direction = sample(option);
      else if (option.parameter == "loop")
        options.loop = true;
      else if (option.parameter != "pattern")
        options.params.emplace_back(option.parameter, sample(option));
      const auto incoming = sent(options);
      ASSERT_TRUE(incoming.items.at(0).request.has_value())
          << incoming.items.at(0).request.error().message;
    }
  }
}

TEST(EffectOptions, TextForANumberIsRefusedByTheDaemon) {
  const auto incoming = sent({.method = "effect.circle", .params = {{"speed_pins_s", "fast"}}});
  ASSERT_FALSE(incoming.items.at(0).request.has_value());
  EXPECT_THAT(incoming.items.at(0).request.error().message, HasSubstr("speed_pins_s"));
  EXPECT_FALSE(play_params({.method = "effect.circle", .params = {{"axis", "1,2,3,4"}}}));
}

TEST(Hold, EndsByItsDurationWithoutALease) {
  const PlayOptions brief{
      .method = "effect.hold", .direction = "left", .params = {{"duration_ms", "500"}}};
  EXPECT_FALSE(brief.held());
  EXPECT_THAT(*play_params(brief), testing::Not(testing::HasSubstr("lease_ms")));
  EXPECT_TRUE(PlayOptions{.method = "effect.hold"}.held());
}

std::string duration_of(const PlayOptions& options) {
  for (const auto& [name, value] : options.params)
    if (name == "duration_ms") return value;
  return "none";
}

TEST(Circle, IsOneTurnUnlessAnEndIsGiven) {
  const auto circle = [](std::vector<std::pair<std::string, std::string>> params) {
    return with_end({.method = "effect.circle", .params = std::move(params)});
  };
  EXPECT_EQ(duration_of(circle({})), "1500") << "15 pins, 10 a second";
  EXPECT_EQ(duration_of(circle({{"ring_deg", "45"}})), "1100");
  EXPECT_EQ(duration_of(circle({{"speed_pins_s", "30"}})), "500");
  EXPECT_EQ(duration_of(circle({{"duration_ms", "300"}})), "300");
  EXPECT_EQ(duration_of(circle({{"lease_ms", "300"}})), "none") << "until Ctrl-C";
  const PlayOptions slow = circle({{"speed_pins_s", "1"}});
  EXPECT_EQ(duration_of(slow), "none");
  EXPECT_EQ(slow.hold_s, 15.0) << "longer than an effect may last: renewed";
  EXPECT_TRUE(slow.held());
  EXPECT_EQ(duration_of(circle({{"speed_pins_s", "fast"}})), "none");
  EXPECT_EQ(duration_of(with_end({.method = "effect.vibrate"})), "none");
}

}  // namespace
}  // namespace hedgehog::client
