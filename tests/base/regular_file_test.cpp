// SPDX-License-Identifier: MIT
// Files that a state directory may contain by mistake: reading them neither blocks nor continues
// forever.
#include "base/regular_file.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <string>

#include "base/atomic_file.h"
#include "tests/temporary_folder.h"

namespace hedgehog::base {
namespace {

namespace fs = std::filesystem;

TEST(RegularFile, IsReadWholeUpToItsBound) {
  const TemporaryFolder folder;
  const std::string text = std::string("a\0b\n", 4) + std::string(100'000, 'x');
  const std::string path = folder.write("file", text);
  EXPECT_EQ(read_regular_file(path, text.size()).text, text);
  EXPECT_TRUE(read_regular_file(path, text.size()).good());
  const FileText larger = read_regular_file(path, 65'536);
  EXPECT_EQ(larger.problem, "is larger than 64 KiB");
  EXPECT_EQ(larger.text, "");
  EXPECT_TRUE(read_regular_file(folder.write("empty", ""), 0).good());
  EXPECT_EQ(read_regular_file(folder.write("byte", "1"), 0).problem, "is larger than 0 bytes");
}

TEST(RegularFile, OfUnreportedSizeIsReadAndBoundedToo) {
  const FileText zero_size = read_regular_file("/proc/self/status", 1 << 20);
  EXPECT_NE(zero_size.text.find("Pid:"), std::string::npos);
  EXPECT_EQ(read_regular_file("/proc/self/status", 100).problem, "is larger than 100 bytes");
}

TEST(RegularFile, MissingIsNoError) {
  const TemporaryFolder folder;
  EXPECT_TRUE(read_regular_file(folder.path("none"), 10).missing);
  EXPECT_TRUE(read_regular_file(folder.write("file", "") + "/none", 10).missing);
  EXPECT_FALSE(read_regular_file(folder.path("none"), 10).good());
  EXPECT_FALSE(read_regular_file(folder.path(), 10).missing);
}

TEST(RegularFile, NothingElseIsRead) {
  const TemporaryFolder folder;
  const std::string fifo = folder.path("fifo");
  ASSERT_EQ(::mkfifo(fifo.c_str(), 0600), 0);
  const std::string socket = folder.path("socket");
  const int listener = ::socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  std::copy(socket.begin(), socket.end(), address.sun_path);
  ASSERT_EQ(::bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
  EXPECT_EQ(read_regular_file(fifo, 10).problem, "is a FIFO, not a regular file");
  EXPECT_EQ(read_regular_file(folder.path(), 10).problem, "is a folder, not a regular file");
  EXPECT_FALSE(read_regular_file(socket, 10).good());
  for (const char* device : {"/dev/zero", "/dev/full", "/dev/null", "/dev/random"})
    EXPECT_EQ(read_regular_file(device, 10).problem, "is a device, not a regular file") << device;
  ::close(listener);
}

TEST(RegularFile, ALinkIsFollowed) {
  const TemporaryFolder folder;
  folder.write("real", "text");
  fs::create_symlink("real", folder.path("link"));
  fs::create_symlink("/dev/full", folder.path("device"));
  fs::create_symlink("loop", folder.path("loop"));
  EXPECT_EQ(read_regular_file(folder.path("link"), 10).text, "text");
  EXPECT_EQ(read_regular_file(folder.path("device"), 10).problem,
            "is a device, not a regular file");
  EXPECT_FALSE(read_regular_file(folder.path("loop"), 10).good());
}

TEST(AtomicFile, IsNotBlockedByALeftoverFifo) {
  const TemporaryFolder folder;
  const std::string path = folder.path("state.json");
  ASSERT_EQ(::mkfifo((path + ".new").c_str(), 0600), 0);
  EXPECT_EQ(write_file_atomically(path, "text"), "");
  EXPECT_EQ(folder.read("state.json"), "text");
  fs::create_symlink("elsewhere", path + ".new");
  EXPECT_EQ(write_file_atomically(path, "more"), "");
  EXPECT_FALSE(fs::exists(folder.path("elsewhere"))) << "nor is it written through";
  fs::create_directory(path + ".new");
  EXPECT_NE(write_file_atomically(path, "again"), "");
  EXPECT_EQ(folder.read("state.json"), "more");
}

}  // namespace
}  // namespace hedgehog::base
