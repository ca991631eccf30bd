// SPDX-License-Identifier: MIT
// The daemon's state directory, as seen by the person who administers it.
#pragma once

#include <optional>
#include <string>

#include "clients/lib/address.h"

namespace hedgehog::client {

/// `given`, else that of the service, `service_folder`, for root, and for others who have none of
/// their own; else $XDG_STATE_HOME/hedgehog (~/.local/state/hedgehog), that of a daemon started by
/// hand.
std::string state_folder(const std::optional<std::string>& given, const Environment& environment,
                         bool root, const std::string& service_folder = "/var/lib/hedgehog");

/// Holds the folder for itself until it goes away: of several programs that change a file in it,
/// none undoes what another did. Makes the folder, 0750, when there is none.
class FolderLock {
 public:
  explicit FolderLock(const std::string& folder);
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;
  ~FolderLock();

  /// Why it is not held, a sentence; empty: it is.
  const std::string& problem() const noexcept { return problem_; }

 private:
  int fd_ = -1;
  std::string problem_;
};

}  // namespace hedgehog::client
