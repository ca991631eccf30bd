// SPDX-License-Identifier: MIT
// The destination of log lines: the journal only when it really reads this stderr.
#include "daemon/logging.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <string>

namespace hedgehog::daemon {
namespace {

class JournalStream : public testing::Test {
 protected:
  JournalStream() { EXPECT_EQ(::pipe2(pipe_.data(), O_CLOEXEC), 0); }
  ~JournalStream() override {
    for (const int fd : pipe_) ::close(fd);
  }
  /// The value that systemd would set for the file open as `fd`.
  static std::string name_of(int fd) {
    struct stat file {};
    EXPECT_EQ(::fstat(fd, &file), 0);
    return std::to_string(file.st_dev) + ":" + std::to_string(file.st_ino);
  }

  std::array<int, 2> pipe_{-1, -1};
};

TEST_F(JournalStream, IdentifiesTheFileByDeviceAndInode) {
  EXPECT_TRUE(is_journal(name_of(pipe_[1]).c_str(), pipe_[1]));
}

TEST_F(JournalStream, IsInheritedByProgramsWhoseStderrIsAnother) {
  std::array<int, 2> other{-1, -1};
  ASSERT_EQ(::pipe2(other.data(), O_CLOEXEC), 0);
  EXPECT_FALSE(is_journal(name_of(other[1]).c_str(), pipe_[1]));
  for (const int fd : other) ::close(fd);
}

TEST_F(JournalStream, OfAnyOtherFormatIsNone) {
  const std::string name = name_of(pipe_[1]);
  EXPECT_FALSE(is_journal(nullptr, pipe_[1]));
  for (const std::string& text : {std::string(), std::string("1"), std::string("8:"), name + "0",
                                  name + ":0", "0" + name, " " + name})
    EXPECT_FALSE(is_journal(text.c_str(), pipe_[1])) << text;
  EXPECT_FALSE(is_journal(name.c_str(), -1));
}

}  // namespace
}  // namespace hedgehog::daemon
