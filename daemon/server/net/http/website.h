// SPDX-License-Identifier: MIT
// Resources by path: the dashboard's pages, /metrics, /healthz. /ws is upgraded by the HTTP
// connection; here is only its access control.
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

  HttpAnswer answer(const HttpRequest& request);
  /// Why `request` gets nothing here, whatever it asks; counted and logged. nullopt: welcome.
  std::optional<HttpAnswer> refusal(const HttpRequest& request);
  /// Gives `session` the role of the request's token. Why not, as 401 or 503. Without a token the
  /// session stays as it is.
  std::optional<HttpAnswer> log_in(Session& session, const HttpRequest& request);

 private:
  /// What is not the same for everybody.
  HttpAnswer live_answer(const std::string& path);
  HttpAnswer health() const;
  HttpAnswer page(const HttpRequest& request) const;
  /// Of a trip, as the page that lists it links it: "/recordings/trip-0017.hhr".
  HttpAnswer recording(const std::string& name) const;

  Server& server_;
  WebPages pages_;
  std::vector<std::string> allow_origins_;
};

}  // namespace hedgehog::server
