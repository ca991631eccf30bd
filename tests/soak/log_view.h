// SPDX-License-Identifier: MIT
// Search in the daemon's log without re-reading all of it each time.
#pragma once

#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <utility>

namespace hedgehog::soak {

class LogView {
 public:
  explicit LogView(std::string path) : path_(std::move(path)) {}

  /// The whole log so far.
  const std::string& text() {
    std::ifstream file(path_, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(text_.size()));
    text_.append(std::istreambuf_iterator<char>(file), {});
    return text_;
  }
  std::size_t count(std::string_view part) {
    text();
    std::size_t found = 0;
    for (auto at = text_.find(part); at != std::string::npos; at = text_.find(part, at + 1))
      ++found;
    return found;
  }
  /// True if one line contains both.
  bool has_line(std::string_view first, std::string_view second) {
    text();
    for (auto at = text_.find(first); at != std::string::npos; at = text_.find(first, at + 1)) {
      const std::string_view rest = std::string_view(text_).substr(at);
      if (rest.substr(0, rest.find('\n')).find(second) != std::string_view::npos) return true;
    }
    return false;
  }

 private:
  std::string path_;
  std::string text_;
};

}  // namespace hedgehog::soak
