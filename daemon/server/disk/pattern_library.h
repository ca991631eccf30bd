// SPDX-License-Identifier: MIT
// The named patterns: the shipped ones, built in from config/patterns and read-only, and those put
// by clients, named vendor/name and stored on disk.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "daemon/server/disk/disk_work.h"
#include "protocol/methods.h"
#include "protocol/values/pattern.h"
#include "protocol/wire/error.h"

namespace hedgehog::server {

/// Put patterns. Called on the io thread; the disk thread writes. nullptr: its queue is full.
class PatternStorage {
 public:
  virtual ~PatternStorage() = default;
  virtual DiskWorkPtr keep(const std::string& name, std::string json) = 0;
  virtual DiskWorkPtr drop(const std::string& name) = 0;
};

/// io thread only.
class PatternLibrary {
 public:
  static constexpr std::size_t kMaxPut = 256;
  static constexpr std::size_t kMaxListBytes = 65'000;  // fits into a line of the protocol

  struct Entry {
    protocol::Pattern pattern;
    bool shipped = false;
  };

  /// Contains the shipped ones and those `kept` from earlier runs. `storage` must outlive this.
  PatternLibrary(PatternStorage& storage, std::vector<protocol::Pattern> kept);

  /// nullptr: no such pattern. Valid until the next put or remove.
  const Entry* find(std::string_view name) const noexcept;
  std::vector<std::string_view> names() const;
  /// `pattern.list` as JSON; beyond kMaxListBytes the descriptions of put patterns are empty.
  std::shared_ptr<const std::string> list();
  static protocol::PatternSummary summary(const Entry& entry);

  /// Playable at once; the work ends when it is on disk. An error, without a change: the name is a
  /// shipped one's, there are kMaxPut already, or the disk queue is full.
  protocol::Result<DiskWorkPtr> put(protocol::Pattern pattern);
  protocol::Result<DiskWorkPtr> remove(const std::string& name);

 private:
  PatternStorage& storage_;
  std::map<std::string, Entry, std::less<>> entries_;
  std::size_t put_ = 0;
  std::shared_ptr<const std::string> list_;  // nullptr: not encoded since the last change
};

/// The patterns of config/patterns at build time. Throws std::logic_error if one is invalid.
std::vector<protocol::Pattern> shipped_patterns();

}  // namespace hedgehog::server
