// SPDX-License-Identifier: MIT
// A connection to an MQTT 5 broker, re-established automatically.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "clients/common/problem.h"
#include "clients/mqtt/message.h"

namespace hedgehog::mqtt {

inline constexpr std::uint16_t kMqttPort = 1883;
inline constexpr std::uint16_t kMqttTlsPort = 8883;

struct BrokerOptions {
  std::string host = "127.0.0.1";  // or, with port 0, the path of a Unix socket
  std::uint16_t port = kMqttPort;
  std::string client_id{};  // must be unique at the broker
  std::optional<std::string> user{};
  std::optional<std::string> password{};
  bool tls = false;
  /// Certificates to verify the broker's; empty: those of the system.
  std::string ca_file{};
  int keepalive_s = 15;
  /// Published by the broker when it has lost this client.
  Message will{};
  /// Messages on this topic are returned before all others, even if the queue is full.
  std::string urgent_topic{};
  /// User properties of all published messages.
  std::vector<std::pair<std::string, std::string>> properties{};
};

struct BrokerConnected {};
struct BrokerLost {
  std::string why{};  // reason, without full stop
};
using BrokerNotice = std::variant<BrokerConnected, BrokerLost, Message>;

/// libmosquitto, with a thread for its connection. Used by one other thread.
///
/// `publish` does not block. Without a connection messages of QoS 0 are dropped and up to
/// `kMaxKept` of QoS 1 are kept for the next one; if the broker reads too slowly, up to
/// `kMaxUnsent` of QoS 0 are kept. Retained messages from the broker are outdated and never
/// returned.
class Broker {
 public:
  static constexpr std::size_t kMaxKept = 1000;
  static constexpr std::size_t kMaxUnsent = 64;
  /// Limit of unread messages; more are dropped.
  static constexpr std::size_t kMaxArrived = 256;
  static constexpr std::size_t kMaxPayload = 65'536;

  /// Begins to connect. An error that is permanent: an invalid certificate file.
  static Result<std::unique_ptr<Broker>> open(const BrokerOptions& options);
  /// Publishes the will and disconnects.
  ~Broker();
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;

  /// False: the message was dropped.
  bool publish(const Message& message);
  /// Must be repeated after each BrokerConnected. QoS 0: a late request is worse than a lost one.
  void subscribe(const std::string& filter, Delivery delivery);
  /// The oldest unread notice.
  std::optional<BrokerNotice> next();
  /// Readable while `next` has a notice.
  int descriptor() const noexcept;
  /// Number of messages dropped since the last call.
  std::uint64_t take_dropped() noexcept;

 private:
  struct Impl;
  explicit Broker(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hedgehog::mqtt
