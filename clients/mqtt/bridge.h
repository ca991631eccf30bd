// SPDX-License-Identifier: MIT
// Bridge between a daemon and a broker: status, events and telemetry in one direction, requests in
// the other.
#pragma once

#include <chrono>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "clients/lib/connection.h"
#include "clients/mqtt/broker.h"
#include "clients/mqtt/home_assistant.h"
#include "clients/mqtt/remote_requests.h"
#include "clients/mqtt/topics.h"

namespace hedgehog::mqtt {

struct BridgeOptions {
  std::vector<client::Address> addresses{};
  std::optional<std::string> token{};
  BrokerOptions broker{};
  std::string prefix = "hedgehog";
  /// nullopt: the serial number of the board, or the name of the ball and of this machine.
  std::optional<std::string> id{};
  double telemetry_hz = 1.0;                                  // 0: none
  protocol::StatusKeys fields = protocol::kTelemetryDefault;  // of telemetry
  double status_s = 10.0;  // publishing interval of an unchanged status
  /// nullopt: no discovery for Home Assistant.
  std::optional<std::string> home_assistant{"homeassistant"};
};

/// One thread. Both connections are re-established automatically; effects end with the connection
/// to the daemon.
class Bridge {
 public:
  using Report = std::function<void(const std::string&)>;

  /// `report` receives occasional sentences for the user.
  Bridge(const BridgeOptions& options, Report report);

  /// Runs until `stop`. An error that is permanent: `Broker::open` fails, or the daemon refuses the
  /// token.
  Result<void> run(const std::function<bool()>& stop);

 private:
  using TimePoint = client::Clock::time_point;

  void wait() const;
  Result<void> handle_daemon();
  client::Outcome<void> connect();
  /// Identifies the ball; its name is the client's name at the broker.
  client::Outcome<void> introduce(client::Connection& daemon);
  client::Outcome<void> exchange();
  client::Outcome<void> request_status();
  void take(const client::Notification& notification);
  void take(const protocol::Reply& reply);
  void on_lost(const std::string& why);
  Result<void> open_broker();
  void handle_broker();
  /// Publishes all retained messages, after a connection was re-established.
  void announce();
  void request(const Message& message);
  void publish(std::string topic, std::string payload, Delivery delivery);
  void retain(std::string topic, std::string payload);
  void publish_all(const std::vector<Message>& messages);
  void report_once(const std::string& message);

  BridgeOptions options_;
  Report report_;
  Topics topics_;
  std::unique_ptr<Broker> broker_;
  bool broker_connected_ = false;
  std::optional<client::Connection> daemon_;
  client::Backoff backoff_;
  TimePoint next_attempt_{};
  TimePoint status_due_{};
  std::optional<protocol::Id> status_request_;
  TimePoint response_due_{};  // of the response to `status_request_`
  PendingRequests pending_;
  BallIdentity ball_;
  std::string description_;  // JSON, from the last connection
  std::string status_;       // JSON, the newest
  std::string reported_;
};

}  // namespace hedgehog::mqtt
