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
  /// As sent, "/metrics?x=1".
  std::string target;
  /// Empty if absent, or sent more than once.
  std::string host;
  std::optional<std::string> origin{};
  // Empty if absent.
  std::string if_none_match{};
  std::string accept_encoding{};
  /// Fetch Metadata (W3C): site of the requester, "cross-site", and purpose, "navigate".
  std::string fetch_site{};
  std::string fetch_mode{};
  /// Of `Authorization: Bearer`; nullopt: absent.
  std::optional<std::string> token{};
  /// Received over TLS, from "192.0.2.7:5000".
  bool tls = false;
  std::string address{};

  /// The target without its query.
  std::string path() const { return target.substr(0, target.find('?')); }
};

struct HttpResponse {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body = std::make_shared<std::string>();
  /// Including the quotes; empty: none.
  std::string etag{};
  std::string cache_control = "no-store";
  /// Encoding of the body, "gzip", and the header it depends on, "Accept-Encoding". Empty: none.
  std::string encoding{};
  std::string vary{};
  /// File name for saving the body; empty: to be displayed.
  std::string filename{};
  /// Polled until it returns the body, which the disk thread reads; none: the body is complete.
  std::function<std::shared_ptr<const std::string>()> pending{};
  /// Permitted methods, "GET, HEAD".
  std::optional<std::string> allow{};
  /// Value of `WWW-Authenticate`; empty: none.
  std::string challenge{};
  /// The request contained a valid token.
  bool authorized = false;
};

/// An error as one sentence for display.
inline HttpResponse http_error(int status, const std::string& sentence) {
  return {status, "text/plain; charset=utf-8", std::make_shared<std::string>(sentence + "\n")};
}

}  // namespace hedgehog::server
