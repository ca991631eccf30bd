// SPDX-License-Identifier: MIT
// Put patterns in the state directory: patterns/vendor/name.json, written by rename.
#pragma once

#include <string>
#include <vector>

#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/disk/pattern_library.h"

namespace hedgehog::server {

class PatternFiles final : public PatternStorage {
 public:
  PatternFiles(const std::string& state_directory, DiskThread& disk);

  /// All stored patterns; damaged, unreadable and foreign files are skipped and logged. Temporary
  /// files of aborted writes are removed. Start-up only.
  std::vector<protocol::Pattern> load() const;

  DiskWorkPtr keep(const std::string& name, std::string json) override;
  DiskWorkPtr drop(const std::string& name) override;

 private:
  std::string path_of(const std::string& name) const;
  /// Adds the pattern of one file to `kept`.
  void load(const std::string& path, std::vector<protocol::Pattern>& kept) const;
  DiskWorkPtr post(std::function<std::string()> job);

  std::string directory_;
  DiskThread& disk_;
};

}  // namespace hedgehog::server
