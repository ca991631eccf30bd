// SPDX-License-Identifier: MIT
// Records received in one search for balls.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "clients/lib/discovery/discovered_ball.h"
#include "clients/lib/discovery/mdns_message.h"

namespace hedgehog::client::mdns {

/// One thread at a time. Bounded: records beyond the limits are dropped.
class Answers {
 public:
  /// Limit of instances, and of names with services, texts or addresses each.
  static constexpr std::size_t kMaxNames = 256;
  static constexpr std::size_t kMaxAddresses = 16;

  /// `id`: of the queries; responses with another id are ignored.
  explicit Answers(std::uint16_t id) : id_(id) {}

  /// A query for the service, and for missing records of instances that have answered.
  std::string query() const;
  /// Reads a datagram of any content; true if it contained records of interest.
  bool read(std::string_view packet);
  /// The balls whose host, port and address are known: by name, then by address, IPv4 first.
  std::vector<DiscoveredBall> balls() const;

 private:
  struct Service {
    std::string host;
    std::uint16_t port = 0;
  };
  void keep(Record record);

  std::uint16_t id_;
  // By name in lower case.
  std::map<std::string, std::string> instances_;
  std::map<std::string, Service> services_;
  std::map<std::string, std::map<std::string, std::string>> texts_;
  std::map<std::string, std::vector<std::string>> addresses_;
};

}  // namespace hedgehog::client::mdns
