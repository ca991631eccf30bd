// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <regex>
#include <string_view>

#include "tests/structure/rules.h"

namespace hedgehog::structure {
namespace {

bool contains(const std::vector<std::string>& sorted, const std::string& value) {
  return std::binary_search(sorted.begin(), sorted.end(), value);
}

bool is_code(std::string_view path) { return path.ends_with(".h") || path.ends_with(".cpp"); }

bool is_cmake(std::string_view path) {
  return path.ends_with("CMakeLists.txt") || path.ends_with(".cmake");
}

bool is_script(std::string_view path) { return path.ends_with(".sh"); }

std::string file_name(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

bool has_licence(const SourceFile& file) {
  static constexpr std::string_view kLicence = "SPDX-License-Identifier: MIT";
  // The first line of a script is its interpreter.
  const std::size_t head_lines =
      std::min<std::size_t>(file.lines.size(), is_script(file.path) ? 2 : 1);
  return std::any_of(
      file.lines.begin(), file.lines.begin() + static_cast<std::ptrdiff_t>(head_lines),
      [](const std::string& line) { return line.find(kLicence) != std::string::npos; });
}

}  // namespace

Violations check_file_shape(const SourceFile& file) {
  Violations violations;
  const auto broken = [&](const std::string& reason) {
    violations.push_back(file.path + ": " + reason);
  };
  if (is_code(file.path) || is_cmake(file.path) || is_script(file.path)) {
    if (!has_licence(file)) broken("does not begin with the SPDX licence line");
  }
  if (!is_code(file.path)) return violations;
  if (file.lines.size() > kMaxLines) {
    broken("has " + std::to_string(file.lines.size()) + " lines, more than " +
           std::to_string(kMaxLines) + ": it holds two things");
  }
  static const std::regex kSnakeCase("[a-z][a-z0-9_]*\\.(h|cpp)");
  if (!std::regex_match(file_name(file.path), kSnakeCase)) broken("name is not snake_case");
  if (file.path.ends_with(".h") &&
      std::find(file.lines.begin(), file.lines.end(), "#pragma once") == file.lines.end())
    broken("has no #pragma once");
  return violations;
}

Violations check_machine_paths(const SourceFile& file) {
  // Spelt in two parts, so that this file passes its own rule.
  static const std::array<std::string, 4> kMachinePaths{
      std::string("/wo") + "rk/", std::string("/ho") + "me/", std::string("/ro") + "ot/",
      std::string("/Use") + "rs/"};
  Violations violations;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    for (const std::string& path : kMachinePaths) {
      const std::size_t found = file.lines[i].find(path);
      if (found == std::string::npos) continue;
      // Only at the start of a path: not within "rules/home/" or "network/".
      const char before = found == 0 ? ' ' : file.lines[i][found - 1];
      const bool starts = std::string_view(" \t\"'`(=:<>,@").find(before) != std::string_view::npos;
      if (starts) {
        violations.push_back(file.path + ":" + std::to_string(i + 1) + ": path of a machine, " +
                             path);
      }
    }
  }
  return violations;
}

Violations check_using(const SourceFile& file) {
  static const std::regex kUsing(R"(^\s*(?:using [\w:]*::(\w+);|namespace (\w+) = [\w:]+;).*)");
  Violations violations;
  if (!file.path.ends_with(".cpp")) return violations;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    std::smatch using_name;
    if (!std::regex_match(file.lines[i], using_name, kUsing)) continue;
    const std::string name = using_name[1].matched ? using_name[1] : using_name[2];
    const std::regex word("(^|[^\\w])" + name + "([^\\w]|$)");
    const bool used =
        std::any_of(file.lines.begin(), file.lines.end(), [&](const std::string& line) {
          const std::string code = line.substr(0, line.find("//"));
          return &line != &file.lines[i] && code.find(name) != std::string::npos &&
                 std::regex_search(code, word);
        });
    if (!used)
      violations.push_back(file.path + ":" + std::to_string(i + 1) + ": nothing uses " + name);
  }
  return violations;
}

Violations check_included_sources(const SourceFile& file) {
  static const std::regex kIncludesSource(R"(^\s*#\s*include\s*["<].*\.(c|cc|cpp|cxx)[">].*)");
  Violations violations;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    if (!std::regex_match(file.lines[i], kIncludesSource)) continue;
    violations.push_back(file.path + ":" + std::to_string(i + 1) + ": includes a source file");
  }
  return violations;
}

Violations check_links(const SourceFile& file, const SourceTree& tree) {
  static const std::regex kLink(R"(\]\(([^)#\s]+)(#[^)]*)?\))");
  Violations violations;
  if (!file.path.ends_with(".md")) return violations;
  bool fenced = false;
  for (std::size_t i = 0; i < file.lines.size(); ++i) {
    const std::string& line = file.lines[i];
    if (line.starts_with("```")) fenced = !fenced;
    if (fenced) continue;
    for (std::sregex_iterator it(line.begin(), line.end(), kLink), end; it != end; ++it) {
      const std::string target = (*it)[1];
      if (target.find("://") != std::string::npos || target.starts_with("mailto:")) continue;
      std::string path = (std::filesystem::path(folder_of(file.path)) / target)
                             .lexically_normal()
                             .generic_string();
      while (path.ends_with('/')) path.pop_back();
      if (path == "." || contains(tree.names, path) || contains(tree.folders, path)) continue;
      violations.push_back(file.path + ":" + std::to_string(i + 1) + ": link to " + target +
                           " leads nowhere");
    }
  }
  return violations;
}

Violations check_folder_sizes(const SourceTree& tree) {
  std::map<std::string, std::size_t> sources;
  for (const std::string& path : tree.names)
    if (is_code(path) && !path.starts_with("tests/")) ++sources[folder_of(path)];
  Violations violations;
  for (const auto& [folder, count] : sources) {
    if (count <= kMaxSources) continue;
    violations.push_back(folder + ": has " + std::to_string(count) + " files in C++, more than " +
                         std::to_string(kMaxSources));
  }
  return violations;
}

Violations check_readmes(const SourceTree& tree) {
  Violations violations;
  for (const std::string& folder : tree.folders) {
    const bool hidden = folder.front() == '.';
    const bool top_level = folder.find('/') == std::string::npos;
    const bool layer = contains(tree.names, folder + "/CMakeLists.txt");
    // tests/README.md describes the folders of tests/.
    const bool inside_tests = folder.starts_with("tests/");
    if (hidden || inside_tests || !(top_level || layer)) continue;
    if (!contains(tree.names, folder + "/README.md"))
      violations.push_back(folder + ": no README.md");
  }
  return violations;
}

Violations check_readme_size(const SourceFile& file) {
  if (!file.path.ends_with("/README.md") || file.path == "protocol/README.md" ||
      file.lines.size() <= kMaxReadmeLines)
    return {};
  return {file.path + ": has " + std::to_string(file.lines.size()) + " lines, more than " +
          std::to_string(kMaxReadmeLines)};
}

Violations check_test_names(const SourceTree& tree) {
  static const std::regex kNamespace("namespace ([a-z_:]+) \\{");
  // A constant, a type, or the whole head of a function.
  static const std::regex kDefinition(
      "(?:static |inline )?const(?:expr)? [^={(]*\\b(k[A-Z]\\w*)(?:\\[\\w*\\])*(?: =|\\{).*"
      "|(?:struct|class|enum class) (\\w+)(?: .*)?\\{"
      "|(\\w[^;=]* \\w+\\(.*\\)(?: const| noexcept)*) \\{.*");
  Violations violations;
  std::map<std::string, std::string> defined_in;
  for (const SourceFile& file : tree.files) {
    if (!file.path.starts_with("tests/") || !file.path.ends_with(".cpp")) continue;
    const std::size_t folder_end = file.path.find('/', std::string_view("tests/").size());
    const std::string folder = file.path.substr(0, folder_end);
    std::string scope;
    for (const std::string& line : file.lines) {
      std::smatch match;
      if (std::regex_match(line, match, kNamespace)) {
        scope += match[1].str() + "::";
      } else if (!scope.empty() && std::regex_match(line, match, kDefinition)) {
        const std::string name = match[1].str() + match[2].str() + match[3].str();
        const auto [other, first] = defined_in.try_emplace(folder + " " + scope + name, file.path);
        if (!first && other->second != file.path)
          violations.push_back(file.path + ": " + name + " is in " + other->second + " too");
      }
    }
  }
  return violations;
}

}  // namespace hedgehog::structure
