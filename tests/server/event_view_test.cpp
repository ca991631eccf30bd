// SPDX-License-Identifier: MIT
// Events as they are sent to clients.
#include "daemon/server/rpc/view/event_view.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>

#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

std::string text_of(control::EventType type, double temperature_c) {
  control::Event event;
  event.type = type;
  event.limit_a = 9.0;
  event.temperature_c = temperature_c;
  return protocol::encode_event(event_view(event, nullptr, 0, {}).value());
}

TEST(EventView, AnUnknownTemperatureIsLeftOut) {
  for (const auto type :
       {control::EventType::kDeratingStarted, control::EventType::kDeratingEnded}) {
    EXPECT_NE(text_of(type, 61.234).find(R"("temperature_c":61.23)"), std::string::npos);
    const std::string unknown = text_of(type, std::numeric_limits<double>::infinity());
    EXPECT_EQ(unknown.find("temperature_c"), std::string::npos) << unknown;
    EXPECT_NE(unknown.find(R"("limit_a":9)"), std::string::npos);
  }
}

TEST(EventView, ARejectedMeasurementNamesItsWindingAndTheQuantities) {
  control::Event event;
  event.type = control::EventType::kMeasurementRejected;
  event.disagreement = {2, control::Quantity::kThermistor, control::Quantity::kHeatBalance};
  EXPECT_EQ(
      protocol::encode_event(event_view(event, nullptr, 5, {}).value()),
      R"({"jsonrpc":"2.0","method":"event","params":{"type":"measurement_rejected","time_ns":5,)"
      R"("disagreement":{"coil":2,"between":["heat_balance","thermistor"]}}})");
}

}  // namespace
}  // namespace hedgehog::server
