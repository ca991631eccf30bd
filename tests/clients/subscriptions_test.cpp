// SPDX-License-Identifier: MIT
// The subscriptions that are renewed on the next connection.
#include "clients/lib/subscriptions.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace hedgehog::client {
namespace {

using protocol::Id;
using testing::IsEmpty;
using testing::SizeIs;

const RawRequest kEvents{"events.subscribe", R"({"types":["state_changed"]})"};

TEST(Subscriptions, AreActiveOnceTheDaemonHasAcceptedThem) {
  Subscriptions subscriptions;
  subscriptions.on_request(Id::number(2), kEvents);
  EXPECT_THAT(subscriptions.current(), IsEmpty());
  subscriptions.on_response(Id::number(2), true);
  ASSERT_THAT(subscriptions.current(), SizeIs(1));
  EXPECT_EQ(std::get<RawRequest>(subscriptions.current()[0].request).params_json,
            kEvents.params_json);
}

TEST(Subscriptions, ThatWereRefusedOrGotNoResponseAreNotActive) {
  Subscriptions subscriptions;
  subscriptions.on_request(Id::number(2), kEvents);
  subscriptions.on_response(Id::number(2), false);
  subscriptions.on_request(Id::number(3), kEvents);
  subscriptions.on_connection_lost();
  subscriptions.on_response(Id::number(3), true);
  EXPECT_THAT(subscriptions.current(), IsEmpty());
}

TEST(Subscriptions, AreOneOfEachKind) {
  Subscriptions subscriptions;
  subscriptions.on_notification(kEvents);
  subscriptions.on_notification(protocol::Request(protocol::TelemetrySubscribe{.rate_hz = 5.0}));
  subscriptions.on_notification(protocol::Request(protocol::TelemetrySubscribe{.rate_hz = 20.0}));
  ASSERT_THAT(subscriptions.current(), SizeIs(2));
  const auto& last = std::get<protocol::Request>(subscriptions.current()[1].request);
  EXPECT_EQ(std::get<protocol::TelemetrySubscribe>(last).rate_hz, 20.0);
}

TEST(Subscriptions, EndWithTheirOwnUnsubscribe) {
  Subscriptions subscriptions;
  subscriptions.on_notification(kEvents);
  subscriptions.on_notification(protocol::Request(protocol::TelemetrySubscribe{}));
  subscriptions.on_request(Id::number(4), protocol::Request(protocol::EventsUnsubscribe{}));
  EXPECT_THAT(subscriptions.current(), SizeIs(2)) << "not answered yet";
  subscriptions.on_response(Id::number(4), true);
  ASSERT_THAT(subscriptions.current(), SizeIs(1));
  subscriptions.on_notification(RawRequest{"telemetry.unsubscribe", ""});
  EXPECT_THAT(subscriptions.current(), IsEmpty());
}

TEST(Subscriptions, ThatWereEndedAreNotRestoredByALateAcceptance) {
  Subscriptions subscriptions;
  subscriptions.on_request(Id::number(2), kEvents);
  subscriptions.on_notification(RawRequest{"events.unsubscribe", ""});
  subscriptions.on_response(Id::number(2), true);
  EXPECT_THAT(subscriptions.current(), IsEmpty()) << "it was sent before its end was";

  subscriptions.on_request(Id::number(3), kEvents);
  subscriptions.on_request(Id::number(4), RawRequest{"events.unsubscribe", ""});
  subscriptions.on_response(Id::number(4), true);
  subscriptions.on_response(Id::number(3), true);
  EXPECT_THAT(subscriptions.current(), IsEmpty()) << "in whichever order the responses come";

  subscriptions.on_request(Id::number(5), kEvents);
  subscriptions.on_response(Id::number(5), true);
  EXPECT_THAT(subscriptions.current(), SizeIs(1)) << "subscribed to anew";
}

TEST(Subscriptions, OfTwoTheOneSentLastIsActive) {
  Subscriptions subscriptions;
  subscriptions.on_request(Id::number(2), kEvents);
  subscriptions.on_notification(RawRequest{"events.subscribe", R"({"scope":"all"})"});
  subscriptions.on_response(Id::number(2), true);
  ASSERT_THAT(subscriptions.current(), SizeIs(1));
  EXPECT_EQ(std::get<RawRequest>(subscriptions.current()[0].request).params_json,
            R"({"scope":"all"})");
}

TEST(Subscriptions, StayUnchangedIfALaterChangeIsRefused) {
  Subscriptions subscriptions;
  subscriptions.on_request(Id::number(2), kEvents);
  subscriptions.on_request(Id::number(3), RawRequest{"events.subscribe", R"({"types":["no"]})"});
  subscriptions.on_response(Id::number(3), false);
  subscriptions.on_response(Id::number(2), true);
  ASSERT_THAT(subscriptions.current(), SizeIs(1));
  EXPECT_EQ(std::get<RawRequest>(subscriptions.current()[0].request).params_json,
            kEvents.params_json);
}

TEST(Subscriptions, ByAnInvalidNotificationAreNotActive) {
  Subscriptions subscriptions;
  subscriptions.on_notification(kEvents);
  for (const char* bad : {R"({"types":["no such type"]})", R"({"of":1})", "[1]", "{", "\n"})
    subscriptions.on_notification(RawRequest{"events.subscribe", bad});
  subscriptions.on_notification(RawRequest{"events.unsubscribe", R"({"types":["state_changed"]})"});
  subscriptions.on_notification(protocol::Request(protocol::TelemetrySubscribe{.rate_hz = 1e6}));
  ASSERT_THAT(subscriptions.current(), SizeIs(1)) << "the daemon refused those, unheard";
  EXPECT_EQ(std::get<RawRequest>(subscriptions.current()[0].request).params_json,
            kEvents.params_json);
  subscriptions.on_notification(RawRequest{"of_the_future.subscribe", R"({"of":1})"});
  EXPECT_THAT(subscriptions.current(), SizeIs(2)) << "whose parameters nobody here knows";
}

TEST(Subscriptions, EndWhenTheDaemonRefusesToRenewThem) {
  Subscriptions subscriptions;
  subscriptions.on_notification(kEvents);
  subscriptions.on_connection_lost();
  const auto renew = [&](int id) {
    subscriptions.on_renewal(Id::number(id), Subscriptions::Held(subscriptions.current()[0]));
  };
  renew(2);
  EXPECT_EQ(subscriptions.on_response(Id::number(2), true), std::nullopt);
  renew(3);
  subscriptions.on_connection_lost();
  EXPECT_THAT(subscriptions.current(), SizeIs(1)) << "not answered: due again";
  renew(4);
  EXPECT_EQ(subscriptions.on_response(Id::number(4), false), "events.subscribe");
  EXPECT_THAT(subscriptions.current(), IsEmpty());
}

TEST(Subscriptions, ThatWereReplacedMeanwhileOutliveARefusedRenewal) {
  Subscriptions subscriptions;
  subscriptions.on_notification(kEvents);
  subscriptions.on_renewal(Id::number(2), Subscriptions::Held(subscriptions.current()[0]));
  subscriptions.on_notification(RawRequest{"events.subscribe", R"({"scope":"all"})"});
  EXPECT_EQ(subscriptions.on_response(Id::number(2), false), std::nullopt);
  EXPECT_THAT(subscriptions.current(), SizeIs(1));
}

TEST(Subscriptions, AreNotChangedByOtherRequests) {
  Subscriptions subscriptions;
  subscriptions.on_notification(protocol::Request(protocol::Ping{}));
  subscriptions.on_notification(RawRequest{"of.the.future", "{}"});
  subscriptions.on_request(Id::number(5), RawRequest{"effect.hold", R"({"direction":"up"})"});
  subscriptions.on_response(Id::number(5), true);
  EXPECT_THAT(subscriptions.current(), IsEmpty());
}

}  // namespace
}  // namespace hedgehog::client
