// SPDX-License-Identifier: MIT
// What `hedgehogctl play` takes for a file, and what for the name of a pattern.
#include "clients/ctl/patterns/pattern_file.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace hedgehog::client {
namespace {

/// An empty working directory for as long as it lives.
class EmptyFolder {
 public:
  EmptyFolder() { std::filesystem::current_path(folder_.path()); }
  ~EmptyFolder() { std::filesystem::current_path(before_); }
  EmptyFolder(const EmptyFolder&) = delete;
  EmptyFolder& operator=(const EmptyFolder&) = delete;

 private:
  std::filesystem::path before_ = std::filesystem::current_path();
  TemporaryFolder folder_;
};

TEST(PatternFile, ANameIsAFileWhenItEndsInJsonUnlessItIsAVendorsAndThereIsNoSuchFile) {
  const EmptyFolder here;
  EXPECT_FALSE(is_pattern_file("heartbeat"));
  EXPECT_FALSE(is_pattern_file("acme/knock"));
  EXPECT_TRUE(is_pattern_file("mine.json")) << "no shipped pattern ends so";
  EXPECT_TRUE(is_pattern_file("/nowhere/mine.json"));
  EXPECT_TRUE(is_pattern_file("Patterns/mine.json")) << "capitals are no pattern's name";
  EXPECT_FALSE(is_pattern_file("acme/x.json")) << "a legal name, and no file";
  EXPECT_TRUE(is_pattern_file("./acme/x.json"));
  std::filesystem::create_directory("acme");
  EXPECT_FALSE(is_pattern_file("acme/x.json"));
  std::ofstream("acme/x.json") << "{}";
  EXPECT_TRUE(is_pattern_file("acme/x.json")) << "the file is nearer";
}

TEST(PatternFile, WhatIsNoRegularFileIsRefusedWithoutWaitingForIt) {
  const TemporaryFolder folder;
  const std::string fifo = folder.path("fifo.json");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  EXPECT_EQ(read_text(fifo).error().message, fifo + ": is a FIFO, not a regular file");
  EXPECT_EQ(read_text("/dev/full").error().message, "/dev/full: is a device, not a regular file");
  EXPECT_EQ(read_text(folder.path()).error().message,
            folder.path() + ": is a folder, not a regular file");
  EXPECT_EQ(read_text(folder.path("none")).error().failure, Failure::kNoInput);
  EXPECT_EQ(read_text(folder.write("some.json", "{}")).value(), "{}");
}

}  // namespace
}  // namespace hedgehog::client
