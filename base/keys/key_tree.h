// SPDX-License-Identifier: MIT
// Matches the tree of a file with a list of keys.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/keys/file_error.h"
#include "base/keys/key.h"
#include "base/keys/value.h"

namespace hedgehog::keys {

struct Origin {
  std::string file;
  int line = 0;
};

/// Position where each key was set last, for errors found after all files are read.
using Origins = std::map<std::string, Origin>;

/// Calls `found(i, value)` for each `paths[i]` in `root`; `found` returns why the value is
/// rejected. Everything else in `root` is an error: unknown keys (with the nearest known one),
/// duplicate keys, sections that are not objects.
void match_keys(const Value& root, const std::string& file, const std::vector<std::string>& paths,
                const std::function<Reason(std::size_t, const Value&)>& found, Origins& origins,
                FileErrors& errors);

/// Reads the keys in `root` into `target`; the rest of `target` is unchanged.
template <class Target>
void read_keys(const Value& root, const std::string& file, const std::vector<Key<Target>>& keys,
               Target& target, Origins& origins, FileErrors& errors) {
  std::vector<std::string> paths;
  paths.reserve(keys.size());
  for (const Key<Target>& key : keys) paths.push_back(key.path);
  match_keys(
      root, file, paths,
      [&](std::size_t i, const Value& value) { return keys[i].read(target, value); }, origins,
      errors);
}

template <class Target>
Value write_keys(const std::vector<Key<Target>>& keys, const Target& target) {
  Value root = Value::object();
  for (const Key<Target>& key : keys) root.put(key.path, key.write(target));
  return root;
}

/// An error about `key` where it was set, or about `fallback_file` if it was not set.
FileError error_at(const Origins& origins, const std::string& key, std::string reason,
                   const std::string& fallback_file);

}  // namespace hedgehog::keys
