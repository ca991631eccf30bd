// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/structure/source_tree.h"

namespace hedgehog::structure {

// Each rule returns its violations, as "path:line: reason" (or "path: reason"); empty: none.
using Violations = std::vector<std::string>;

// A layer includes only the layers to which the diagram in README.md has an arrow.
Violations check_layer_includes(const SourceFile& file);

// Which libraries a layer may include: no JSON in any header, no JSON, Asio or spdlog in the
// control path.
Violations check_library_includes(const SourceFile& file);

// Licence line, #pragma once, snake_case name, at most kMaxLines lines.
inline constexpr std::size_t kMaxLines = 300;
Violations check_file_shape(const SourceFile& file);

// No absolute path of a developer's machine.
Violations check_machine_paths(const SourceFile& file);

// A source file uses each name that it declares with `using a::b;` or `namespace b = a;`.
// (clang-tidy checks this too, but not for sources in a batch.)
Violations check_using(const SourceFile& file);

// No #include of a source file; batches of the build are not in the tree.
Violations check_included_sources(const SourceFile& file);

// No two sources of the same folder of tests define the same constant, type or function in the same
// namespace: builds with sanitizers compile all tests of a program as one.
Violations check_test_names(const SourceTree& tree);

// Names of the product use the terms of CONTRIBUTING.md.
Violations check_terms(const SourceFile& file);

// Relative links of a Markdown file lead to existing files or folders.
Violations check_links(const SourceFile& file, const SourceTree& tree);

// Each message that the first column of a table quotes, `like … this`, occurs in a source of the
// product.
Violations check_quoted_messages(const SourceFile& page, const SourceTree& tree);

// A message without a row, quoted like one, and why it needs none.
struct Unexplained {
  std::string quoted;
  std::string reason;
};

// What a program prints when something is wrong: the calls, initializers and assignments in the
// sources of `folder` that begin with one of `openers`, and the page with a row for each.
struct ProgramMessages {
  std::string folder;
  std::vector<std::string> openers;
  std::string page;
  std::vector<Unexplained> unexplained;
};

// Each message of the program has a row; what is listed as unexplained is in a source.
Violations check_explained_messages(const ProgramMessages& program, const SourceTree& tree);

// Each name of a protocol's error in `errors` has a row.
Violations check_explained_errors(const SourceFile& errors, const SourceFile& page);

// A folder of the product has at most kMaxSources files in C++, without those of its subfolders;
// a larger folder has more than one purpose.
inline constexpr std::size_t kMaxSources = 24;
Violations check_folder_sizes(const SourceTree& tree);

// Every top-level folder and every layer has a README.
Violations check_readmes(const SourceTree& tree);

// The README of a folder is one screen: at most kMaxReadmeLines, details are in other pages. The
// protocol's is its specification.
inline constexpr std::size_t kMaxReadmeLines = 60;
Violations check_readme_size(const SourceFile& file);

}  // namespace hedgehog::structure
