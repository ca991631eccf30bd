// SPDX-License-Identifier: MIT
// Which subscriptions the next connection makes again.
#include "clients/lib/subscriptions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hedgehog::client {
namespace {

using protocol::Id;
using testing::IsEmpty;
using testing::SizeIs;

const RawRequest kEvents{"events.subscribe", R"({"types":["armed"]})"};

TEST(Subscriptions, HoldOnceTheDaemonHasAcceptedThem) {
  Subscriptions subscriptions;
  subscriptions.asked(Id::number(2), kEvents);
  EXPECT_THAT(subscriptions.current(), IsEmpty());
  subscriptions.answered(Id::number(2), true);
  ASSERT_THAT(subscriptions.current(), SizeIs(1));
  EXPECT_EQ(std::get<RawRequest>(subscriptions.current()[0]).params_json, kEvents.params_json);
}

TEST(Subscriptions, ThatWereRefusedOrNotAnsweredDoNotHold) {
  Subscriptions subscriptions;
  subscriptions.asked(Id::number(2), kEvents);
  subscriptions.answered(Id::number(2), false);
  subscriptions.asked(Id::number(3), kEvents);
  subscriptions.connection_lost();
  subscriptions.answered(Id::number(3), true);
  EXPECT_THAT(subscriptions.current(), IsEmpty());
}

TEST(Subscriptions, AreOneOfEachKind) {
  Subscriptions subscriptions;
  subscriptions.notified(kEvents);
  subscriptions.notified(protocol::Request(protocol::TelemetrySubscribe{.rate_hz = 5.0}));
  subscriptions.notified(protocol::Request(protocol::TelemetrySubscribe{.rate_hz = 20.0}));
  ASSERT_THAT(subscriptions.current(), SizeIs(2));
  const auto& last = std::get<protocol::Request>(subscriptions.current()[1]);
  EXPECT_EQ(std::get<protocol::TelemetrySubscribe>(last).rate_hz, 20.0);
}

TEST(Subscriptions, EndWithTheirOwnUnsubscribe) {
  Subscriptions subscriptions;
  subscriptions.notified(kEvents);
  subscriptions.notified(protocol::Request(protocol::TelemetrySubscribe{}));
  subscriptions.asked(Id::number(4), protocol::Request(protocol::EventsUnsubscribe{}));
  EXPECT_THAT(subscriptions.current(), SizeIs(2)) << "not answered yet";
  subscriptions.answered(Id::number(4), true);
  ASSERT_THAT(subscriptions.current(), SizeIs(1));
  subscriptions.notified(RawRequest{"telemetry.unsubscribe", ""});
  EXPECT_THAT(subscriptions.current(), IsEmpty());
}

TEST(Subscriptions, AreNoOtherRequests) {
  Subscriptions subscriptions;
  subscriptions.notified(protocol::Request(protocol::Ping{}));
  subscriptions.notified(RawRequest{"of.the.future", "{}"});
  subscriptions.asked(Id::number(5), RawRequest{"effect.hold", R"({"direction":"up"})"});
  subscriptions.answered(Id::number(5), true);
  EXPECT_THAT(subscriptions.current(), IsEmpty());
}

}  // namespace
}  // namespace hedgehog::client
