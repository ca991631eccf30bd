// SPDX-License-Identifier: MIT
// Resources by path: the dashboard's pages, /metrics, /healthz; of /ws only its access control.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "daemon/server/net/http/http_message.h"
#include "daemon/server/net/http/web_pages.h"
#include "daemon/server/rpc/server.h"

namespace hedgehog::server {

/// io thread only.
class Website {
 public:
  /// `pages`: the folder.
  Website(Server& server, const std::string& pages, std::vector<std::string> allow_origins);

  HttpResponse answer(const HttpRequest& request);
  /// Response to a `request` that is rejected for any path; counted and logged. nullopt: accepted.
  std::optional<HttpResponse> refusal(const HttpRequest& request);
  /// Gives `session` the role of the request's token, if it has one. Returns the error, 401 or 503.
  std::optional<HttpResponse> log_in(Session& session, const HttpRequest& request);

 private:
  HttpResponse live_response(const std::string& path);  // not static
  HttpResponse health() const;
  HttpResponse page(const HttpRequest& request) const;
  /// Recording of a trip, linked by the page that lists it: "/recordings/trip-0017.hhr".
  HttpResponse recording(const std::string& name) const;

  Server& server_;
  WebPages pages_;
  std::vector<std::string> allow_origins_;
};

}  // namespace hedgehog::server
