// SPDX-License-Identifier: MIT
#include "clients/racer/server/host_check.h"

#include <arpa/inet.h>

#include <algorithm>

namespace hedgehog::racer {
namespace {

constexpr std::uint16_t kHttpPort = 80;  // browsers leave it out

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return out;
}

struct HostName {
  std::string name;  // without brackets
  bool bracketed = false;
};

/// `host` without `port`; nullopt: not that port.
std::optional<HostName> name_at(std::string_view host, std::uint16_t port) {
  const std::string ending = ":" + std::to_string(port);
  if (host.ends_with(ending))
    host.remove_suffix(ending.size());
  else if (port != kHttpPort)
    return std::nullopt;
  if (host.starts_with('[') && host.ends_with(']'))
    return HostName{lower(host.substr(1, host.size() - 2)), true};
  return HostName{lower(host), false};
}

bool is_v4(const std::string& name) {
  in_addr address{};
  return inet_pton(AF_INET, name.c_str(), &address) == 1;
}

bool is_v6(const std::string& name) {
  in6_addr address{};
  return inet_pton(AF_INET6, name.c_str(), &address) == 1;
}

}  // namespace

bool HostCheck::is_ours(std::string_view host) const {
  const auto found = name_at(host, port);
  if (!found) return false;
  const auto& [name, bracketed] = *found;
  if (bracketed) return is_v6(name) && (name == "::1" || name == address || address == "::");
  if (name == "localhost") return true;
  return is_v4(name) &&
         (name.starts_with("127.") || name == address || address == "0.0.0.0" || address == "::");
}

bool HostCheck::may_connect(std::string_view host, std::optional<std::string_view> origin) const {
  return is_ours(host) && (!origin || lower(*origin) == "http://" + lower(host));
}

}  // namespace hedgehog::racer
