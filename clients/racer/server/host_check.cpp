// SPDX-License-Identifier: MIT
#include "clients/racer/server/host_check.h"

#include "base/web_host.h"

namespace hedgehog::racer {
namespace {

constexpr std::uint16_t kHttpPort = 80;  // omitted by browsers

}  // namespace

bool HostCheck::is_own_host(std::string_view host) const {
  const base::WebHost given = base::parse_web_host(host);
  if (given.is_local()) return true;
  if (given.port ? *given.port != std::to_string(port) : port != kHttpPort) return false;
  if (given.is_v6()) return address == "::" || given.name == "[" + address + "]";
  return given.is_v4() && (given.name == address || address == "0.0.0.0" || address == "::");
}

bool HostCheck::may_connect(std::string_view host, std::optional<std::string_view> origin) const {
  return is_own_host(host) && (!origin || base::is_origin_of(*origin, host));
}

}  // namespace hedgehog::racer
