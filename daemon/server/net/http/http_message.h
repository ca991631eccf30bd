// SPDX-License-Identifier: MIT
// HTTP requests and responses as values, without sockets and without an HTTP library.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace hedgehog::server {

struct HttpRequest {
  std::string method;
  std::string target;  // as sent, "/metrics?x=1"
  std::string host;    // empty if absent, or sent more than once
  std::optional<std::string> origin{};
  std::string if_none_match{};    // empty if absent
  std::string accept_encoding{};  // empty if absent
  /// Fetch Metadata (W3C): site of the requester, "cross-site", and purpose, "navigate".
  std::string fetch_site{};
  std::string fetch_mode{};
  std::optional<std::string> token{};  // of "Authorization: Bearer"; nullopt: absent
  bool tls = false;
  std::string address{};  // "192.0.2.7:5000"

  std::string path() const { return target.substr(0, target.find('?')); }  // without the query
};

struct HttpResponse {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body = std::make_shared<std::string>();
  std::string etag{};  // including the quotes; empty: none
  std::string cache_control = "no-store";
  /// Encoding of the body, "gzip", and the header it depends on, "Accept-Encoding". Empty: none.
  std::string encoding{};
  std::string vary{};
  std::string filename{};  // for saving the body; empty: to be displayed
  /// Polled until it returns the body, which the disk thread reads; none: the body is complete.
  std::function<std::shared_ptr<const std::string>()> pending{};
  std::optional<std::string> allow{};  // permitted methods, "GET, HEAD"
  std::string challenge{};             // of "WWW-Authenticate"; empty: none
  bool authorized = false;             // the request contained a valid token
};

/// An error as one sentence for display.
inline HttpResponse http_error(int status, const std::string& sentence) {
  return {status, "text/plain; charset=utf-8", std::make_shared<std::string>(sentence + "\n")};
}

}  // namespace hedgehog::server
