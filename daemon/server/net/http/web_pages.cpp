// SPDX-License-Identifier: MIT
#include "daemon/server/net/http/web_pages.h"

namespace hedgehog::server {

WebPages::WebPages(const std::string& folder)
    : files_(base::read_web_files(folder, base::WebFolder::kWithSubfolders, kMaxBytes)) {
  if (files_.too_large) {
    problem_ = folder + ": larger than 32 MB, so not the dashboard's pages; none are served";
  } else if (files_.error) {
    files_.by_path.clear();
    problem_ = folder + ": " + files_.error.message() + "; the dashboard is not served";
  } else if (files_.find("/") == nullptr) {
    problem_ = folder + ": no index.html there; the dashboard is not served";
  }
}

}  // namespace hedgehog::server
