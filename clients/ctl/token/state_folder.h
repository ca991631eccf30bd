// SPDX-License-Identifier: MIT
// The daemon's state directory, for administration.
#pragma once

#include <optional>
#include <string>

#include "clients/lib/address.h"

namespace hedgehog::client {

/// `given` if set; else that of the service, `service_folder`, for root, and for other users
/// without one of their own; else $XDG_STATE_HOME/hedgehog (~/.local/state/hedgehog), that of a
/// daemon started by hand.
std::string state_folder(const std::optional<std::string>& given, const Environment& environment,
                         bool root, const std::string& service_folder = "/var/lib/hedgehog");

/// Exclusive lock on the folder until destruction: of several programs that change a file in it,
/// none overwrites the changes of another. Creates the folder, 0750, if it does not exist.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Why it is not locked, a sentence; empty: it is.
  const std::string& problem() const noexcept { return problem_; }

 private:
  int fd_ = -1;
  std::string problem_;
};

}  // namespace hedgehog::client
