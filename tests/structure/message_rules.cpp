// SPDX-License-Identifier: MIT
// Compares the messages quoted in troubleshooting.md with the string literals of the sources.
#include <algorithm>
#include <string_view>

#include "tests/structure/rules.h"

namespace hedgehog::structure {
namespace {

/// The file's text with the literals of adjacent lines joined, as the compiler does.
std::string joined_literals(const SourceFile& file) {
  std::string text;
  for (const std::string& line : file.lines) {
    const std::size_t begin = std::min(line.find_first_not_of(' '), line.size());
    const bool joins = text.ends_with('"') && line.compare(begin, 1, "\"") == 0;
    if (joins)
      text.pop_back();
    else
      text += '\n';
    text.append(line, joins ? begin + 1 : begin);
  }
  return text;
}

std::vector<std::string> texts_of_sources(const SourceTree& tree) {
  std::vector<std::string> texts;
  for (const SourceFile& file : tree.files)
    if (file.path.ends_with(".cpp") && !file.path.starts_with("tests/"))
      texts.push_back(joined_literals(file));
  return texts;
}

/// "a … b" -> "a ", " b".
std::vector<std::string> pieces_of(std::string_view quoted) {
  constexpr std::string_view kGap = "…";
  std::vector<std::string> pieces;
  while (!quoted.empty()) {
    const std::size_t end = std::min(quoted.find(kGap), quoted.size());
    if (end > 0) pieces.emplace_back(quoted.substr(0, end));
    quoted.remove_prefix(std::min(end + kGap.size(), quoted.size()));
  }
  return pieces;
}

}  // namespace

Violations check_quoted_messages(const SourceFile& file, const SourceTree& tree) {
  const std::vector<std::string> texts = texts_of_sources(tree);
  Violations violations;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string& line = file.lines[i];
    if (!line.starts_with("| `")) continue;
    const std::size_t end = line.find('`', 3);
    for (const std::string& piece : pieces_of(std::string_view(line).substr(3, end - 3))) {
      const bool said = std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
        return text.find(piece) != std::string::npos;
      });
      if (!said) {
        violations.push_back(file.path + ":" + std::to_string(i + 1) + ": no source says \"" +
                             piece + "\"");
      }
    }
  }
  return violations;
}

}  // namespace hedgehog::structure
