// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "tests/structure/source_tree.h"

namespace hedgehog::structure {

// Each rule returns what breaks it, as "path:line: reason" (or "path: reason"); empty when all is
// well.
using Violations = std::vector<std::string>;

// Where an include may point to: the arrows of the layer picture in README.md.
Violations check_layer_includes(const SourceFile& file);

// Which libraries a layer may see: no JSON in any header, no JSON, Asio or spdlog in the control
// path.
Violations check_library_includes(const SourceFile& file);

// Licence line, #pragma once, snake_case name, at most kMaxLines lines.
inline constexpr std::size_t kMaxLines = 300;
Violations check_file_shape(const SourceFile& file);

// No path of somebody's machine.
Violations check_machine_paths(const SourceFile& file);

// What a source file brings in with `using a::b;` or `namespace b = a;` occurs in it once more.
// (clang-tidy knows this too, but not of sources in a batch.)
Violations check_using(const SourceFile& file);

// No #include of a source file; batches of the build are not in the tree.
Violations check_included_sources(const SourceFile& file);

// Names of the product use the terms of CONTRIBUTING.md.
Violations check_terms(const SourceFile& file);

// Relative links of a Markdown file lead somewhere.
Violations check_links(const SourceFile& file, const SourceTree& tree);

// Each message that the first column of a table quotes, `like … this`, is in a source of the
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

// A folder of the product has at most kMaxSources files in C++, without those of its subfolders:
// with more it holds two things.
inline constexpr std::size_t kMaxSources = 24;
Violations check_folder_sizes(const SourceTree& tree);

// Every top-level folder and every layer says in a README what lives there.
Violations check_readmes(const SourceTree& tree);

}  // namespace hedgehog::structure
