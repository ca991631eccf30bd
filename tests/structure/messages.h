// SPDX-License-Identifier: MIT
// Messages in the sources, and in the first column of a page's tables: | `like … this` |.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "tests/structure/source_tree.h"

namespace hedgehog::structure {

struct Message {
  std::string path;
  std::size_t line = 0;  // of a page; 0: of a source
  std::string text;
};

/// The file's text with the literals of adjacent lines joined, as the compiler does.
std::string joined_literals(const SourceFile& file);

/// The messages that the page quotes.
std::vector<Message> quoted_messages(const SourceFile& page);

/// The literals of each call, initializer or assignment that begins with one of `openers`
/// ("spdlog::warn(", "problem_ = "), with "…" between them; "Problem(" stands for "Problem{" too.
/// Those without a word are left out: what is printed there is made elsewhere.
std::vector<Message> messages_in(const SourceFile& source, const std::vector<std::string>& openers);

/// "a … b" -> "a ", " b".
std::vector<std::string> pieces_of(std::string_view quoted);

/// `text` has the pieces of `quoted` in this order. A quote of a single word is the name of an
/// error, and explains no sentence.
bool explains(const std::string& quoted, const std::string& text);

}  // namespace hedgehog::structure
