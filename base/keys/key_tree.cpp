// SPDX-License-Identifier: MIT
#include "base/keys/key_tree.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string_view>
#include <utility>

#include "base/spelling.h"

namespace hedgehog::keys {
namespace {

std::string_view last_part(std::string_view path) {
  return path.substr(path.rfind('.') == std::string_view::npos ? 0 : path.rfind('.') + 1);
}

/// Every key and every section that leads to one.
std::set<std::string> known_names(const std::vector<std::string>& paths) {
  std::set<std::string> names(paths.begin(), paths.end());
  for (const std::string& path : paths)
    for (std::size_t dot = path.find('.'); dot != std::string::npos; dot = path.find('.', dot + 1))
      names.insert(path.substr(0, dot));
  return names;
}

/// Suggests a key for a typo or for a key in the wrong section; of few keys all.
Reason unknown_key(const std::string& path, const std::vector<std::string>& paths) {
  std::string nearest;
  std::size_t fewest = 1 + std::max<std::size_t>(2, path.size() / 4);
  if (path.size() <= 64) {
    for (const std::string& name : known_names(paths)) {
      const std::size_t edits =
          last_part(name) == last_part(path) ? 1 : base::edits_between(path, name);
      if (edits < fewest) {
        fewest = edits;
        nearest = name;
      }
    }
  }
  if (!nearest.empty()) return "unknown key; did you mean \"" + nearest + "\"?";
  constexpr std::size_t kFew = 12;
  if (paths.size() > kFew) return "unknown key";
  return fmt::format("unknown key; there are {}", fmt::join(paths, ", "));
}

class Matcher {
 public:
  Matcher(const std::string& file, const std::vector<std::string>& paths,
          const std::function<Reason(std::size_t, const Value&)>& found, Origins& origins,
          FileErrors& errors)
      : file_(file), paths_(paths), found_(found), origins_(origins), errors_(errors) {}

  // parse_json limits the depth of the recursion.
  void match(const Value& section, const std::string& prefix) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < section.keys.size(); ++i) {
      const std::string path = prefix + section.keys[i];
      const Value& value = section.elements[i];
      if (!seen.insert(section.keys[i]).second)
        refuse(value, path, "given twice");
      else
        member(value, path);
    }
  }

 private:
  void member(const Value& value, const std::string& path) {
    const auto key = std::find(paths_.begin(), paths_.end(), path);
    if (key != paths_.end()) {
      origins_[path] = {file_, value.line};
      const Reason reason = found_(static_cast<std::size_t>(key - paths_.begin()), value);
      if (!reason.empty()) refuse(value, path, reason);
      return;
    }
    const bool is_section = std::any_of(paths_.begin(), paths_.end(), [&](const std::string& p) {
      return p.starts_with(path + ".");
    });
    if (!is_section)
      refuse(value, path, unknown_key(path, paths_));
    else if (value.kind != Value::Kind::kObject)
      refuse(value, path, must_be("an object", value));
    else
      match(value, path + ".");
  }

  void refuse(const Value& value, const std::string& path, Reason reason) {
    errors_.push_back({file_, value.line, path, std::move(reason)});
  }

  const std::string& file_;
  const std::vector<std::string>& paths_;
  const std::function<Reason(std::size_t, const Value&)>& found_;
  Origins& origins_;
  FileErrors& errors_;
};

}  // namespace

void match_keys(const Value& root, const std::string& file, const std::vector<std::string>& paths,
                const std::function<Reason(std::size_t, const Value&)>& found, Origins& origins,
                FileErrors& errors) {
  if (root.kind != Value::Kind::kObject) {
    errors.push_back({file, root.line, "", must_be("an object in braces", root)});
    return;
  }
  Matcher(file, paths, found, origins, errors).match(root, "");
}

FileError error_at(const Origins& origins, const std::string& key, std::string reason,
                   const std::string& fallback_file) {
  const auto found = origins.find(key);
  if (found == origins.end()) return {fallback_file, 0, key, std::move(reason)};
  return {found->second.file, found->second.line, key, std::move(reason)};
}

}  // namespace hedgehog::keys
