// SPDX-License-Identifier: MIT
// What has been answered to one search for balls.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "clients/lib/discovery/discovered_ball.h"
#include "clients/lib/discovery/mdns_message.h"

namespace hedgehog::client::mdns {

/// One thread at a time. Bounded: a flood of records makes it forget the later ones.
class Answers {
 public:
  /// Of instances, and of names with services, texts or addresses each.
  static constexpr std::size_t kMaxNames = 256;
  static constexpr std::size_t kMaxAddresses = 16;

  /// `id` of its queries and of the responses that count.
  explicit Answers(std::uint16_t id) : id_(id) {}

  /// Asks for the service, and for what is missing of those that have answered.
  std::string query() const;
  /// A datagram, whatever it has. Whether something in it was of interest.
  bool read(std::string_view packet);
  /// Those of which a host, a port and an address are known: by name, then by address, IPv4 first.
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
