// SPDX-License-Identifier: MIT
// The requests in the README are accepted by the daemon's decoder.
#include <gtest/gtest.h>

#include <fstream>
#include <string>

#include "protocol/server_codec.h"
#include "tests/folders.h"

namespace hedgehog::client {
namespace {

TEST(Readme, ShowsOnlyLinesThatTheDaemonAccepts) {
  std::ifstream readme(source_folder() + "/clients/README.md");
  ASSERT_TRUE(readme.is_open());
  int seen = 0;
  for (std::string line; std::getline(readme, line);) {
    const auto begin = line.find("{\"jsonrpc\"");
    const auto end = line.rfind("}}");
    if (begin == std::string::npos || end == std::string::npos) continue;
    const auto incoming = protocol::decode_line(line.substr(begin, end + 2 - begin));
    // a template that a program completes
    if (incoming.items.at(0).method == std::nullopt) continue;
    EXPECT_TRUE(incoming.items.at(0).request.has_value())
        << line << "\n"
        << incoming.items.at(0).request.error().message;
    ++seen;
  }
  EXPECT_GE(seen, 2);
}

}  // namespace
}  // namespace hedgehog::client
