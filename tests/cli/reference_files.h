// SPDX-License-Identifier: MIT
// Man page and completions of the sample's command line, and the programs that read them.
#pragma once

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include "cli/reference.h"
#include "tests/cli/sample_app.h"
#include "tests/temporary_folder.h"

namespace hedgehog::cli {

/// The output of the shell, with that on stderr.
inline std::string shell(const std::string& command) {
  std::FILE* pipe = ::popen(("{ " + command + "; } 2>&1").c_str(), "r");
  std::string out;
  std::array<char, 4096> bytes{};
  for (std::size_t count = 1; count > 0;) {
    count = std::fread(bytes.data(), 1, bytes.size(), pipe);
    out.append(bytes.data(), count);
  }
  ::pclose(pipe);
  return out;
}

inline bool has(const char* program) {
  return std::system((std::string("command -v ") + program + " >/dev/null").c_str()) == 0;
}

/// The generated files, in a temporary folder.
class Reference : public testing::Test {
 protected:
  Reference() {
    const SampleApp sample;
    EXPECT_EQ(write_reference(sample.app, {"--reference", folder_.path()}), 0);
  }
  std::string path(const std::string& name) const { return folder_.path() + "/" + name; }
  std::string text(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  TemporaryFolder folder_;
};

}  // namespace hedgehog::cli
