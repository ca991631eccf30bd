// SPDX-License-Identifier: MIT
// Reports of the orientation indicator for a daemon's telemetry.
#include "clients/orientation/indicator.h"

#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "tests/clients/fake_daemon.h"

namespace hedgehog::client {
namespace {

std::string telemetry(const std::string& model_c) {
  return R"({"jsonrpc":"2.0","method":"telemetry","params":{"time_ns":1,"temperature_c":)"
         R"({"sensor":null,"model":)" +
         model_c + R"(,"coils":[25,25,25],"age_ms":null}}})";
}

/// The first report of an indicator whose daemon sends `first_line` once.
IndicatorReport report_of(const std::string& first_line) {
  FakeDaemon daemon([&](FakePeer& peer) {
    int id = 0;
    for (const char* result :
         {R"({"state":"armed","reason":null,"limit_a":15})",
          R"({"effect":1,"accepted":true,"current_a":5})", R"({"rate_hz":10,"fields":[]})"}) {
      peer.read();
      peer.send_line(R"({"jsonrpc":"2.0","id":)" + std::to_string(++id) + R"(,"result":)" + result +
                     "}");
    }
    peer.send_line(first_line);
    for (std::string line = peer.read(); !line.empty(); line = peer.read())
      if (line.find("effect.stop_all") != std::string::npos)
        peer.send_line(R"({"jsonrpc":"2.0","id":4,"result":{"stopped":1}})");
  });
  std::optional<IndicatorReport> first;
  {
    Connection connection = Connection::open({daemon.address()}, kLongTimeout).value();
    const auto ended = Indicator(connection, {})
                           .run([&] { return first.has_value(); },
                                [&](const IndicatorReport& report) { first = report; });
    EXPECT_TRUE(ended.has_value()) << ended.error().message;
  }
  return first.value_or(IndicatorReport{});
}

TEST(IndicatorReport, AnUnknownTemperatureIsNotZero) {
  EXPECT_EQ(report_of(telemetry("61.24")).temperature_c, 61.24);
  EXPECT_EQ(report_of(telemetry("null")).temperature_c, std::nullopt);
}

}  // namespace
}  // namespace hedgehog::client
