// SPDX-License-Identifier: MIT
// Between a daemon and a broker: status, events and telemetry go one way, requests the other.
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
  /// nullopt: the serial number of the board, or the ball's name and that of this machine.
  std::optional<std::string> id{};
  double telemetry_hz = 1.0;                                  // 0: none
  protocol::StatusKeys fields = protocol::kTelemetryDefault;  // of telemetry
  double status_s = 10.0;  // how often the status is published that did not change
  /// nullopt: no discovery by Home Assistant.
  std::optional<std::string> home_assistant{"homeassistant"};
};

/// One thread. Both sides may come and go; what plays ends with the connection to the daemon.
class Bridge {
 public:
  using Report = std::function<void(const std::string&)>;

  /// `report` gets a sentence for a person now and then.
  Bridge(const BridgeOptions& options, Report report);

  /// Until `stop`. An error when it can never work: `Broker::open`, or the daemon
  /// refuses the token.
  Result<void> run(const std::function<bool()>& stop);

 private:
  using TimePoint = client::Clock::time_point;

  void wait() const;
  Result<void> handle_daemon();
  client::Outcome<void> connect();
  /// Learns which ball it is; a broker's client has that ball's name.
  client::Outcome<void> introduce(client::Connection& daemon);
  client::Outcome<void> exchange();
  client::Outcome<void> ask_status();
  void take(const client::Notification& notification);
  void take(const protocol::Reply& reply);
  void lose(const std::string& why);
  Result<void> open_broker();
  void handle_broker();
  /// All that is retained, after the broker or the daemon was away.
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
  std::optional<protocol::Id> status_asked_;
  TimePoint answer_due_{};  // to `status_asked_`
  PendingRequests pending_;
  BallIdentity ball_;
  std::string description_;  // JSON, of the last connection
  std::string status_;       // JSON, the newest
  std::string reported_;
};

}  // namespace hedgehog::mqtt
