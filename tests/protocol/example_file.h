// SPDX-License-Identifier: MIT
// The examples of protocol/README.md, in the form that its section "How the examples are written"
// defines, so that they can be replayed against a live daemon.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "protocol/wire/json.h"

namespace hedgehog::protocol {

struct ExampleLine {
  bool sent = false;
  /// The text after the arrow.
  std::string text{};
  /// Line number in the file, for messages.
  int number = 0;
};

/// One fenced block: one connection.
struct Example {
  std::vector<ExampleLine> lines{};
};

/// All blocks marked `hedgehog` of a Markdown text.
std::vector<Example> read_examples(std::string_view markdown);

/// The README of the protocol, read from the source tree.
std::vector<Example> protocol_examples(const std::string& source_dir);

/// Why `actual` does not match `expected`, with the path of the first difference; empty if it
/// matches.
std::string mismatch(const Json& expected, const Json& actual);
/// The same for texts; both must be JSON.
std::string mismatch(std::string_view expected, std::string_view actual);

}  // namespace hedgehog::protocol
