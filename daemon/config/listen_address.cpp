// SPDX-License-Identifier: MIT
#include "daemon/config/listen_address.h"

#include <arpa/inet.h>

#include <algorithm>
#include <array>
#include <charconv>

namespace hedgehog::config {
namespace {

enum class Reach : std::uint8_t { kNotAnAddress, kThisMachine, kOthers };

Reach reach_of(const std::string& host, bool bracketed) {
  if (bracketed) {
    in6_addr v6{};
    if (inet_pton(AF_INET6, host.c_str(), &v6) != 1) return Reach::kNotAnAddress;
    return IN6_IS_ADDR_LOOPBACK(&v6) ? Reach::kThisMachine : Reach::kOthers;
  }
  in_addr v4{};
  if (inet_pton(AF_INET, host.c_str(), &v4) != 1) return Reach::kNotAnAddress;
  return ntohl(v4.s_addr) >> 24 == 127 ? Reach::kThisMachine : Reach::kOthers;
}

bool is_v6(const ListenAddress& address) noexcept {
  return address.host.find(':') != std::string::npos;
}

/// All addresses of its family.
bool is_unspecified(const ListenAddress& address) noexcept {
  return address.host == "0.0.0.0" || address.host == "::";
}

/// The shortest form, "::1" of "0::1": one address has one text.
std::string shortest_v6(const std::string& host) {
  in6_addr v6{};
  std::array<char, INET6_ADDRSTRLEN> text{};
  inet_pton(AF_INET6, host.c_str(), &v6);
  return inet_ntop(AF_INET6, &v6, text.data(), text.size());
}

}  // namespace

boost::system::result<ListenAddress, AddressError> parse_listen_address(std::string_view text) {
  constexpr std::string_view kTls = "tls://";
  const AddressError shape{"must be an address and a port, such as 127.0.0.1:7586 or [::1]:7586"};
  const bool tls = text.starts_with(kTls);
  if (tls) text.remove_prefix(kTls.size());
  const std::size_t colon = text.rfind(':');
  if (colon == std::string_view::npos) return shape;
  std::string_view host = text.substr(0, colon);
  const std::string_view digits = text.substr(colon + 1);
  const bool bracketed = host.size() > 2 && host.front() == '[' && host.back() == ']';
  if (bracketed) host = host.substr(1, host.size() - 2);

  ListenAddress address{std::string(host), 0, tls};
  const auto [end, error] =
      std::from_chars(digits.data(), digits.data() + digits.size(), address.port);
  if (error == std::errc::result_out_of_range) return AddressError{"the port must be 0 to 65535"};
  if (error != std::errc() || end != digits.data() + digits.size()) return shape;
  // inet_pton ignores everything after an embedded NUL.
  if (std::find(host.begin(), host.end(), '\0') != host.end()) return shape;
  const Reach reach = reach_of(address.host, bracketed);
  if (reach != Reach::kNotAnAddress && bracketed) address.host = shortest_v6(address.host);
  switch (reach) {
    case Reach::kNotAnAddress:
      return shape;
    case Reach::kOthers:
      address.tls = true;
      break;
    case Reach::kThisMachine:
      break;
  }
  return address;
}

std::string to_string(const ListenAddress& address) {
  return (address.tls ? "tls://" : "") +
         (is_v6(address) ? "[" + address.host + "]" : address.host) + ":" +
         std::to_string(address.port);
}

bool conflict(const ListenAddress& a, const ListenAddress& b) noexcept {
  if (a.port != b.port || a.port == 0) return false;
  if (is_v6(a) != is_v6(b)) return false;  // the daemon's IPv6 sockets take no IPv4
  return a.host == b.host || is_unspecified(a) || is_unspecified(b);
}

}  // namespace hedgehog::config
