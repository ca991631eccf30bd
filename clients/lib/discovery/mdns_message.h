// SPDX-License-Identifier: MIT
// Messages of multicast DNS as far as a search for services needs them (RFC 1035, RFC 6762). The
// input comes from the network.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace hedgehog::client::mdns {

enum class Kind : std::uint16_t { kA = 1, kPtr = 12, kTxt = 16, kAaaa = 28, kSrv = 33 };

/// Names are in the uncompressed form of RFC 1035: a byte of length before each label, 0 at the
/// end, 255 bytes at most.
struct Question {
  std::string name;
  Kind kind = Kind::kPtr;
};

/// A record of one of the kinds above and class IN, with a time to live above 0.
struct Record {
  std::string name;
  Kind kind = Kind::kPtr;
  std::string target{};                          // kPtr, kSrv: a name
  std::uint16_t port = 0;                        // kSrv
  std::map<std::string, std::string> entries{};  // kTxt: "key=value" by key in lower case
  std::string address{};                         // kA, kAaaa: numeric; not link-local (fe80::/10)
};

/// The records of the response to the search `id`; none if it is malformed anywhere or another
/// message.
std::vector<Record> read_response(std::string_view packet, std::uint16_t id);

/// A query for unicast responses, at most 1200 bytes: the first questions that fit.
std::string make_query(std::uint16_t id, const std::vector<Question>& questions);

/// In lower case: DNS compares ASCII letters without regard to case.
std::string key_of(std::string name);
/// The labels of a name.
std::vector<std::string_view> labels_of(std::string_view name);

}  // namespace hedgehog::client::mdns
