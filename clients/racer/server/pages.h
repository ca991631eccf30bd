// SPDX-License-Identifier: MIT
// The files of the game's page.
#pragma once

#include <string>

#include "base/web_files.h"

namespace hedgehog::racer {

/// The files in `folder`, 16 MB at most. Without index.html "/" is a page that explains how to
/// build it.
base::WebFiles read_pages(const std::string& folder);

/// `share/hedgehog/racer` of the prefix of this program, whose folder is one level below it (bin),
/// or two (clients/racer of a build).
std::string default_pages_folder();

}  // namespace hedgehog::racer
