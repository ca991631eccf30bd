// SPDX-License-Identifier: MIT
#include "clients/racer/server/host_check.h"

#include "base/web_host.h"

namespace hedgehog::racer {

bool is_own_host(std::string_view host) { return base::parse_web_host(host).is_local(); }

bool may_connect(std::string_view host, std::optional<std::string_view> origin) {
  return is_own_host(host) && (!origin || base::is_origin_of(*origin, host));
}

}  // namespace hedgehog::racer
