// SPDX-License-Identifier: MIT
// Put patterns in the state directory: patterns/vendor/name.json, written by rename.
#pragma once

#include <string>
#include <vector>

#include "daemon/server/disk/disk_thread.h"
#include "daemon/server/disk/pattern_library.h"

namespace hedgehog::server {

class PatternFiles final : public PatternShelf {
 public:
  PatternFiles(const std::string& state_directory, DiskThread& disk);

  /// All that are there; what is damaged, cannot be read or is not ours is left out and logged.
  /// What a write left behind that was cut off is removed. Start-up only.
  std::vector<protocol::Pattern> load() const;

  DiskWorkPtr keep(const std::string& name, std::string json) override;
  DiskWorkPtr drop(const std::string& name) override;

 private:
  std::string path_of(const std::string& name) const;
  /// The pattern of one file goes to `kept`.
  void load(const std::string& path, std::vector<protocol::Pattern>& kept) const;
  DiskWorkPtr post(std::function<std::string()> job);

  std::string directory_;
  DiskThread& disk_;
};

}  // namespace hedgehog::server
