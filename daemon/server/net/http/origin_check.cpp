// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/origin_check.h"

#include <algorithm>

#include "base/spelling.h"
#include "base/web_host.h"

namespace hedgehog::server {
namespace {

constexpr std::size_t kMaxShown = 100;

/// Client text, sanitised for a log.
std::string shown(std::string_view text) {
  std::string out(text.substr(0, kMaxShown));
  std::replace_if(
      out.begin(), out.end(), [](char c) { return c < 0x20 || c > 0x7e; }, '?');
  return out;
}

/// True for a request by a page of another site, except for a link to one of these pages. Programs
/// other than browsers send no such header.
bool is_foreign_fetch(const HttpRequest& request) {
  if (request.fetch_site.empty() || request.fetch_site == "same-origin" ||
      request.fetch_site == "none")
    return false;
  return request.fetch_mode != "navigate" || request.target.starts_with(kRecordingsPath);
}

}  // namespace

bool is_own_host(std::string_view host) { return base::parse_web_host(host).is_local(); }

std::optional<Refusal> refused(const HttpRequest& request,
                               const std::vector<std::string>& allow_origins) {
  // With TLS a name that leads here by DNS rebinding does not match the certificate, and a page has
  // no token.
  if (!request.tls && !is_own_host(request.host)) {
    return Refusal{http_error(421, "\"" + shown(request.host) +
                                       "\" is not a name of this machine: use http://127.0.0.1 or "
                                       "http://localhost, and ssh -L from elsewhere"),
                   "host"};
  }
  if (!request.origin) {
    if (!is_foreign_fetch(request)) return std::nullopt;
    return Refusal{http_error(403, "pages of other sites may not load " + shown(request.path())),
                   "origin"};
  }
  const std::string origin = base::lower_case(*request.origin);
  const bool ours = base::is_origin_of(origin, request.host, request.tls);
  const bool allowed = std::any_of(allow_origins.begin(), allow_origins.end(),
                                   [&](const std::string& allowed_origin) {
                                     return base::lower_case(allowed_origin) == origin;
                                   });
  if (ours || allowed) return std::nullopt;
  return Refusal{http_error(403, "pages of " + shown(*request.origin) +
                                     " may not connect: add that origin to http.allow_origins in "
                                     "the daemon's configuration if they shall"),
                 "origin"};
}

}  // namespace hedgehog::server
