// SPDX-License-Identifier: MIT
// The messages that the pages of troubleshooting quote, against those of the sources.
#include <algorithm>
#include <regex>

#include "tests/structure/messages.h"
#include "tests/structure/rules.h"

namespace hedgehog::structure {
namespace {

bool is_source_of(const SourceFile& file, const std::string& folder) {
  return file.path.starts_with(folder) && file.path.ends_with(".cpp");
}

std::vector<std::string> texts_of_sources(const SourceTree& tree) {
  std::vector<std::string> texts;
  for (const SourceFile& file : tree.files)
    if ((file.path.ends_with(".cpp") || file.path.ends_with(".h")) &&
        !file.path.starts_with("tests/"))
      texts.push_back(joined_literals(file));
  return texts;
}

/// Those of the page at this path; none if there is no such page.
std::vector<Message> quotes_of(const SourceTree& tree, const std::string& page) {
  for (const SourceFile& file : tree.files)
    if (file.path == page) return quoted_messages(file);
  return {};
}

/// Openers that find nothing, as after a change of how messages are made.
std::vector<std::string> unused_openers(const ProgramMessages& program, const SourceTree& tree) {
  std::vector<std::string> unused = program.openers;
  for (const SourceFile& file : tree.files) {
    if (!is_source_of(file, program.folder)) continue;
    std::erase_if(unused,
                  [&](const std::string& opener) { return !messages_in(file, {opener}).empty(); });
  }
  return unused;
}

}  // namespace

Violations check_quoted_messages(const SourceFile& page, const SourceTree& tree) {
  const std::vector<std::string> texts = texts_of_sources(tree);
  Violations violations;
  for (const Message& quote : quoted_messages(page)) {
    for (const std::string& piece : pieces_of(quote.text)) {
      const bool printed = std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
        return text.find(piece) != std::string::npos;
      });
      if (!printed) {
        violations.push_back(quote.path + ":" + std::to_string(quote.line) + ": no source says \"" +
                             piece + "\"");
      }
    }
  }
  return violations;
}

Violations check_explained_messages(const ProgramMessages& program, const SourceTree& tree) {
  const std::vector<Message> quotes = quotes_of(tree, program.page);
  std::vector<bool> needed(program.unexplained.size());
  Violations violations;
  for (const SourceFile& file : tree.files) {
    if (!is_source_of(file, program.folder)) continue;
    for (const Message& message : messages_in(file, program.openers)) {
      const auto exception =
          std::find_if(program.unexplained.begin(), program.unexplained.end(),
                       [&](const Unexplained& one) { return explains(one.quoted, message.text); });
      if (exception != program.unexplained.end()) {
        needed[static_cast<std::size_t>(exception - program.unexplained.begin())] = true;
        continue;
      }
      const bool explained = std::any_of(quotes.begin(), quotes.end(), [&](const Message& quote) {
        return explains(quote.text, message.text);
      });
      if (!explained) {
        violations.push_back(message.path + ": no row of " + program.page + " explains \"" +
                             message.text + "\"");
      }
    }
  }
  for (std::size_t i = 0; i < needed.size(); ++i)
    if (!needed[i])
      violations.push_back(program.folder + ": no source says \"" + program.unexplained[i].quoted +
                           "\", which is listed as unexplained");
  for (const std::string& opener : unused_openers(program, tree))
    violations.push_back(program.folder + ": no message begins with " + opener);
  return violations;
}

Violations check_explained_errors(const SourceFile& errors, const SourceFile& page) {
  static const std::regex kName(R"~(^\s*return "([a-z_]+)";)~");
  const std::vector<Message> quotes = quoted_messages(page);
  Violations violations;
  std::size_t names = 0;
  for (std::size_t i = 1; i < errors.lines.size(); ++i) {
    std::smatch found;
    if (errors.lines[i - 1].find("case ErrorCode::") == std::string::npos ||
        !std::regex_search(errors.lines[i], found, kName))
      continue;
    const std::string name = found[1];
    ++names;
    const bool explained = std::any_of(quotes.begin(), quotes.end(),
                                       [&](const Message& quote) { return quote.text == name; });
    if (!explained) {
      violations.push_back(errors.path + ":" + std::to_string(i + 1) + ": no row of " + page.path +
                           " explains " + name);
    }
  }
  if (names == 0) violations.push_back(errors.path + ": names no error");
  return violations;
}

}  // namespace hedgehog::structure
