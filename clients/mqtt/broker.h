// SPDX-License-Identifier: MIT
// A connection to an MQTT 5 broker that is made again by itself.
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
  std::string client_id{};  // at the broker, one connection each
  std::optional<std::string> user{};
  std::optional<std::string> password{};
  bool tls = false;
  /// The certificates that the broker's is checked against; empty: those of the system.
  std::string ca_file{};
  int keepalive_s = 15;
  /// What the broker publishes when it has lost this client.
  Message will{};
  /// A message on this topic is handed out before all others, also when there are too many.
  std::string urgent_topic{};
  /// User properties of everything that is published.
  std::vector<std::pair<std::string, std::string>> properties{};
};

struct BrokerConnected {};
struct BrokerLost {
  std::string why{};  // a clause
};
using BrokerNotice = std::variant<BrokerConnected, BrokerLost, Message>;

/// libmosquitto, with a thread for its connection. One other thread uses this.
///
/// `publish` never waits. While there is no connection messages of QoS 0 are dropped and up to
/// `kMaxKept` of QoS 1 kept for the next one; of a broker that reads too slowly, all but
/// `kMaxUnsent` of QoS 0. A retained message that arrives is an old one and is never handed out.
class Broker {
 public:
  static constexpr std::size_t kMaxKept = 1000;
  static constexpr std::size_t kMaxUnsent = 64;
  /// Messages that nobody has fetched yet; more are dropped.
  static constexpr std::size_t kMaxArrived = 256;
  static constexpr std::size_t kMaxPayload = 65'536;

  /// Begins to connect. An error when that cannot ever work: a certificate file that is none.
  static Result<std::unique_ptr<Broker>> open(const BrokerOptions& options);
  /// Publishes the will, and ends.
  ~Broker();
  Broker(const Broker&) = delete;
  Broker& operator=(const Broker&) = delete;

  /// False: it was dropped.
  bool publish(const Message& message);
  /// Needed again after each BrokerConnected. QoS 0: a request that is late is worse than one that
  /// is lost.
  void subscribe(const std::string& filter, Delivery delivery);
  /// The oldest that nobody has taken.
  std::optional<BrokerNotice> next();
  /// Readable while `next` has something.
  int descriptor() const noexcept;
  /// Messages that were dropped since the last call.
  std::uint64_t take_dropped() noexcept;

 private:
  struct Impl;
  explicit Broker(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace hedgehog::mqtt
