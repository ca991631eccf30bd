// SPDX-License-Identifier: MIT
#include "tests/structure/messages.h"

#include <algorithm>
#include <cctype>

namespace hedgehog::structure {
namespace {

constexpr std::string_view kGap = "…";

/// The index behind the literal that begins at `open`.
std::size_t end_of_literal(const std::string& text, std::size_t open) {
  std::size_t i = open + 1;
  while (i < text.size() && text[i] != '"') i += text[i] == '\\' ? 2 : 1;
  return std::min(i + 1, text.size());
}

/// '"' is a character, 65'536 is a number.
std::size_t end_of_character(const std::string& text, std::size_t open) {
  if (open > 0 && std::isalnum(static_cast<unsigned char>(text[open - 1])) != 0) return open + 1;
  return std::min(open + (text.compare(open + 1, 1, "\\") == 0 ? 4 : 3), text.size());
}

/// The literals from `begin`, behind an opener, to its end: the bracket that closes it, or a
/// semicolon.
std::string literals_from(const std::string& text, std::size_t begin) {
  std::string literals;
  int depth = 1;
  for (std::size_t i = begin; i < text.size() && depth > 0;) {
    const char c = text[i];
    if (c == '"') {
      const std::size_t end = end_of_literal(text, i);
      if (!literals.empty()) literals += kGap;
      literals += text.substr(i + 1, end - i - 2);
      i = end;
      continue;
    }
    if (c == '\'') {
      i = end_of_character(text, i);
      continue;
    }
    if (c == '(' || c == '{') ++depth;
    if (c == ')' || c == '}' || (c == ';' && depth == 1)) --depth;
    ++i;
  }
  return literals;
}

/// Of an object: with parentheses and with braces.
std::vector<std::string> spellings(const std::string& opener) {
  std::vector<std::string> both{opener};
  if (opener.ends_with('(')) both.push_back(opener.substr(0, opener.size() - 1) + "{");
  return both;
}

bool has_word(const std::string& text) {
  const auto is_letter = [](unsigned char c) { return std::isalpha(c) != 0; };
  return std::adjacent_find(text.begin(), text.end(), [&](char a, char b) {
           return is_letter(static_cast<unsigned char>(a)) &&
                  is_letter(static_cast<unsigned char>(b));
         }) != text.end();
}

}  // namespace

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

std::vector<Message> quoted_messages(const SourceFile& page) {
  std::vector<Message> quotes;
  for (std::size_t i = 0; i < page.lines.size(); ++i) {
    const std::string& line = page.lines[i];
    if (!line.starts_with("| `")) continue;
    quotes.push_back({page.path, i + 1, line.substr(3, line.find('`', 3) - 3)});
  }
  return quotes;
}

std::vector<Message> messages_in(const SourceFile& source,
                                 const std::vector<std::string>& openers) {
  const std::string text = joined_literals(source);
  std::vector<Message> messages;
  for (const std::string& opener : openers) {
    for (const std::string& spelling : spellings(opener)) {
      for (std::size_t at = text.find(spelling); at != std::string::npos;
           at = text.find(spelling, at + 1)) {
        std::string literals = literals_from(text, at + spelling.size());
        if (has_word(literals)) messages.push_back({source.path, 0, std::move(literals)});
      }
    }
  }
  return messages;
}

std::vector<std::string> pieces_of(std::string_view quoted) {
  std::vector<std::string> pieces;
  while (!quoted.empty()) {
    const std::size_t end = std::min(quoted.find(kGap), quoted.size());
    if (end > 0) pieces.emplace_back(quoted.substr(0, end));
    quoted.remove_prefix(std::min(end + kGap.size(), quoted.size()));
  }
  return pieces;
}

bool explains(const std::string& quoted, const std::string& text) {
  if (quoted.find(' ') == std::string::npos) return false;
  std::size_t at = 0;
  for (const std::string& piece : pieces_of(quoted)) {
    const std::size_t found = text.find(piece, at);
    if (found == std::string::npos) return false;
    at = found + piece.size();
  }
  return true;
}

}  // namespace hedgehog::structure
