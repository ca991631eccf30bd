// SPDX-License-Identifier: MIT
#include "base/web_host.h"

#include <arpa/inet.h>

#include <algorithm>

#include "base/spelling.h"

namespace hedgehog::base {

bool WebHost::is_v4() const {
  in_addr address{};
  return inet_pton(AF_INET, name.c_str(), &address) == 1;
}

bool WebHost::is_loopback() const {
  return name == "localhost" || name == "[::1]" || (is_v4() && name.starts_with("127."));
}

bool WebHost::is_local() const {
  const auto is_digit = [](char c) { return c >= '0' && c <= '9'; };
  const bool is_port =
      !port || (port->size() <= 5 && std::all_of(port->begin(), port->end(), is_digit));
  return is_loopback() && is_port;
}

WebHost parse_web_host(std::string_view host) {
  const std::size_t bracket = host.starts_with('[') ? host.find(']') : 0;
  const std::size_t colon = bracket == std::string_view::npos ? bracket : host.find(':', bracket);
  if (colon == std::string_view::npos) return {lower_case(host)};
  return {lower_case(host.substr(0, colon)), std::string(host.substr(colon + 1))};
}

bool is_origin_of(std::string_view origin, std::string_view host, bool tls) {
  return lower_case(origin) == (tls ? "https://" : "http://") + lower_case(host);
}

}  // namespace hedgehog::base
