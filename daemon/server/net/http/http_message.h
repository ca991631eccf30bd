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
  /// Empty when there is none, or more than one.
  std::string host;
  std::optional<std::string> origin{};
  // Empty where there is none.
  std::string if_none_match{};
  std::string accept_encoding{};
  /// Fetch Metadata (W3C): who asks, "cross-site", and what for, "navigate".
  std::string fetch_site{};
  std::string fetch_mode{};
  /// Of `Authorization: Bearer`; nullopt: there is none.
  std::optional<std::string> token{};
  /// It came over TLS, from "192.0.2.7:5000".
  bool tls = false;
  std::string address{};

  /// The target without its query.
  std::string path() const { return target.substr(0, target.find('?')); }
};

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body = std::make_shared<std::string>();
  /// With its quotes; empty: none.
  std::string etag{};
  std::string cache_control = "no-store";
  /// Of the body, "gzip"; and what it depends on, "Accept-Encoding". Empty: not so.
  std::string encoding{};
  std::string vary{};
  /// A name to keep the body under; empty: it is to be shown.
  std::string filename{};
  /// Polled until it returns the body, which the disk thread reads; none: the body is there.
  std::function<std::shared_ptr<const std::string>()> pending{};
  /// Methods that would have been right, "GET, HEAD".
  std::optional<std::string> allow{};
  /// Of `WWW-Authenticate`; empty: none.
  std::string challenge{};
  /// Its token was good.
  bool authorized = false;
};

/// An error as one sentence for a person.
inline HttpAnswer http_error(int status, const std::string& sentence) {
  return {status, "text/plain; charset=utf-8", std::make_shared<std::string>(sentence + "\n")};
}

}  // namespace hedgehog::server
