// SPDX-License-Identifier: MIT
// The files of the game's page.
#pragma once

#include <string>

#include "base/web_files.h"

namespace hedgehog::racer {

/// Those in `folder`, 16 MB at most. A folder without index.html has none: "/" then says so in
/// words, and how the page is built.
base::WebFiles read_pages(const std::string& folder);

/// `share/hedgehog/racer` of the prefix that this program stands in: one folder below it (bin), or
/// two (clients/racer of a build).
std::string default_pages_folder();

}  // namespace hedgehog::racer
