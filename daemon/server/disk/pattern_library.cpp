// SPDX-License-Identifier: MIT
#include "daemon/server/disk/pattern_library.h"

#include <stdexcept>
#include <utility>

#include "daemon/server/disk/shipped_patterns.h"
#include "protocol/server_codec.h"

namespace hedgehog::server {
namespace {

using protocol::RpcError;

/// Error for a `name` that clients may not put or remove.
RpcError read_only(const std::string& name) {
  RpcError e = protocol::invalid_params(
      "name",
      "'" + name + "' has no vendor; shipped patterns are read-only, name yours vendor/" + name);
  e.value = name;
  return e;
}

RpcError storage_full() {
  constexpr std::int64_t kRetryMs = 50;
  return protocol::busy("earlier patterns are still being written to disk; nothing was changed",
                        kRetryMs);
}

}  // namespace

PatternLibrary::PatternLibrary(PatternStorage& storage, std::vector<protocol::Pattern> kept)
    : storage_(storage) {
  for (protocol::Pattern& pattern : shipped_patterns()) {
    std::string name = pattern.name;
    entries_.insert_or_assign(std::move(name), Entry{std::move(pattern), true});
  }
  for (protocol::Pattern& pattern : kept) {
    if (protocol::owner_of(pattern.name) == protocol::PatternOwner::kVendor && put_ < kMaxPut) {
      std::string name = pattern.name;
      put_ += entries_.insert_or_assign(std::move(name), Entry{std::move(pattern), false}).second;
    }
  }
}

const PatternLibrary::Entry* PatternLibrary::find(std::string_view name) const noexcept {
  const auto found = entries_.find(name);
  return found == entries_.end() ? nullptr : &found->second;
}

std::vector<std::string_view> PatternLibrary::names() const {
  std::vector<std::string_view> names;
  names.reserve(entries_.size());
  for (const auto& [name, entry] : entries_) names.emplace_back(name);
  return names;
}

std::shared_ptr<const std::string> PatternLibrary::list() {
  if (list_) return list_;
  protocol::PatternsResult all;
  all.patterns.reserve(entries_.size());
  for (const auto& [name, entry] : entries_) all.patterns.push_back(summary(entry));
  std::string json = protocol::encode_value(all);
  if (json.size() > kMaxListBytes) {
    for (protocol::PatternSummary& one : all.patterns)
      one.description = one.shipped ? std::move(one.description) : std::string();
    json = protocol::encode_value(all);
  }
  list_ = std::make_shared<const std::string>(std::move(json));
  return list_;
}

protocol::PatternSummary PatternLibrary::summary(const Entry& entry) {
  const protocol::Pattern& p = entry.pattern;
  return {p.name, p.description, p.keyframes.back().t_ms,
          static_cast<std::int64_t>(p.keyframes.size()), entry.shipped};
}

protocol::Result<DiskWorkPtr> PatternLibrary::put(protocol::Pattern pattern) {
  std::string name = pattern.name;
  if (protocol::owner_of(name) != protocol::PatternOwner::kVendor) return read_only(name);
  const bool known = entries_.contains(name);
  if (!known && put_ >= kMaxPut) {
    RpcError e = protocol::busy("there are 256 patterns already; remove one first", 0);
    e.retry_after_ms.reset();
    e.field = "name";
    e.limit = std::int64_t{kMaxPut};
    return e;
  }
  DiskWorkPtr work = storage_.keep(name, protocol::encode_pattern(pattern) + '\n');
  if (work == nullptr) return storage_full();
  list_.reset();
  put_ += known ? 0 : 1;
  entries_.insert_or_assign(std::move(name), Entry{std::move(pattern), false});
  return work;
}

protocol::Result<DiskWorkPtr> PatternLibrary::remove(const std::string& name) {
  const Entry* entry = find(name);
  if (entry == nullptr) return protocol::no_such_pattern("name", name, names());
  if (entry->shipped) return read_only(name);
  DiskWorkPtr work = storage_.drop(name);
  if (work == nullptr) return storage_full();
  list_.reset();
  entries_.erase(name);
  --put_;
  return work;
}

std::vector<protocol::Pattern> shipped_patterns() {
  std::vector<protocol::Pattern> patterns;
  for (const ShippedFile& file : shipped_pattern_files()) {
    auto pattern = protocol::decode_pattern(file.json);
    if (pattern.has_error() || pattern->name != file.name) {
      throw std::logic_error("config/patterns/" + std::string(file.name) + ".json: " +
                             (pattern.has_error() ? pattern.error().message : "has another name"));
    }
    patterns.push_back(std::move(*pattern));
  }
  return patterns;
}

}  // namespace hedgehog::server
