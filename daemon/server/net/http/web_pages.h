// SPDX-License-Identifier: MIT
// The files of the dashboard, all of them in memory: a path cannot lead to a file that was not in
// the folder at the start.
#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <string>

namespace hedgehog::server {

struct WebPage {
  std::string type;
  std::string etag;
  std::shared_ptr<const std::string> bytes;
};

/// io thread only.
class WebPages {
 public:
  static constexpr std::size_t kMaxBytes = 32u << 20;

  /// Reads `folder` with what is below it; regular files of the known types only, no links. A
  /// folder that is missing, or too large, has no pages: `problem` says why.
  explicit WebPages(const std::string& folder);

  /// "/" is "/index.html". nullptr: there is no such page.
  const WebPage* find(const std::string& path) const;
  /// One sentence; empty: none.
  const std::string& problem() const noexcept { return problem_; }

 private:
  std::map<std::string, WebPage> pages_;
  std::string problem_;
};

}  // namespace hedgehog::server
