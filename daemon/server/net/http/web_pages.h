// SPDX-License-Identifier: MIT
// The files of the dashboard, as they are served.
#pragma once

#include <cstddef>
#include <string>

#include "base/web_files.h"

namespace hedgehog::server {

/// io thread only.
class WebPages {
 public:
  static constexpr std::size_t kMaxBytes = 32u << 20;

  /// Reads `folder` with what is below it. A folder that is missing, or too large, has no pages:
  /// `problem` says why.
  explicit WebPages(const std::string& folder);

  /// "/" is "/index.html". nullptr: there is no such page.
  const base::WebFile* find(const std::string& path) const { return files_.find(path); }
  /// One sentence; empty: none.
  const std::string& problem() const noexcept { return problem_; }

 private:
  base::WebFiles files_;
  std::string problem_;
};

}  // namespace hedgehog::server
