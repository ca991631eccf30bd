// SPDX-License-Identifier: MIT
// HTTP requests and responses as values, without sockets and without an HTTP library.
#pragma once

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
  std::optional<std::string> if_none_match{};

  /// The target without its query.
  std::string path() const { return target.substr(0, target.find('?')); }
};

struct HttpAnswer {
  int status = 200;
  std::string type = "text/plain; charset=utf-8";
  std::shared_ptr<const std::string> body = std::make_shared<std::string>();
  /// With its quotes; empty: the answer is not to be kept.
  std::string etag{};
  /// Methods that would have been right, "GET, HEAD".
  std::optional<std::string> allow{};
};

/// An error as one sentence for a person.
inline HttpAnswer http_error(int status, const std::string& sentence) {
  return {status, "text/plain; charset=utf-8", std::make_shared<std::string>(sentence + "\n")};
}

}  // namespace hedgehog::server
