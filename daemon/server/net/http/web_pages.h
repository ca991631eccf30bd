// SPDX-License-Identifier: MIT
// The served files of the dashboard.
#pragma once

#include <cstddef>
#include <string>

#include "base/web_files.h"

namespace hedgehog::server {

/// io thread only.
class WebPages {
 public:
  static constexpr std::size_t kMaxBytes = 32u << 20;

  /// Reads `folder` and its subfolders; without pages if it is missing or too large (`problem`).
  explicit WebPages(const std::string& folder);

  /// "/" is "/index.html". nullptr: no such page.
  const base::WebFile* find(const std::string& path) const { return files_.find(path); }
  /// One sentence; empty: none.
  const std::string& problem() const noexcept { return problem_; }

 private:
  base::WebFiles files_;
  std::string problem_;
};

}  // namespace hedgehog::server
