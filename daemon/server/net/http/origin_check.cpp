// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/origin_check.h"

#include <arpa/inet.h>

#include <algorithm>

namespace hedgehog::server {
namespace {

constexpr std::size_t kMaxShown = 100;

std::string lower(std::string_view text) {
  std::string out(text);
  std::transform(out.begin(), out.end(), out.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return out;
}

/// A stranger's words, fit for a log.
std::string shown(std::string_view text) {
  std::string out(text.substr(0, kMaxShown));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
  return out;
}

bool is_port(std::string_view text) {
  return text.size() <= 5 &&
         std::all_of(
             text.begin(), text.end(), [](char c) { return c >= '0' && c <= '9'; });
}

}  // namespace

bool is_own_host(std::string_view host) {
  const bool bracketed = host.starts_with('[');
  const std::size_t end = bracketed ? host.find(']') + 1 : std::min(host.find(':'), host.size());
  if (end == 0 || (end < host.size() && (host[end] != ':' || !is_port(host.substr(end + 1)))))
    return false;
  const std::string name = lower(host.substr(0, end));
  in_addr v4{};
  return name == "localhost" || name == "[::1]" ||
         (inet_pton(AF_INET, name.c_str(), &v4) == 1 && ntohl(v4.s_addr) >> 24 == 127);
}

std::optional<Refusal> refused(const HttpRequest& request,
                               const std::vector<std::string>& allow_origins) {
  if (!is_own_host(request.host)) {
    return Refusal{http_error(421, "\"" + shown(request.host) +
                                       "\" is not a name of this machine: use http://127.0.0.1 or "
                                       "http://localhost, and ssh -L from elsewhere"),
                   "host"};
  }
  if (!request.origin) return std::nullopt;
  const std::string origin = lower(*request.origin);
  const bool ours = origin == "http://" + lower(request.host);
  const bool allowed = std::any_of(
      allow_origins.begin(), allow_origins.end(),
      [&](const std::string& allowed_origin) { return lower(allowed_origin) == origin; });
  if (ours || allowed) return std::nullopt;
  return Refusal{http_error(403, "pages of " + shown(*request.origin) +
                                     " may not connect: add that origin to http.allow_origins in "
                                     "the daemon's configuration if they shall"),
                 "origin"};
}

}  // namespace hedgehog::server
