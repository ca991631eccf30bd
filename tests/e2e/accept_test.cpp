// SPDX-License-Identifier: MIT
// Clients that disconnect before they are accepted, and a daemon that cannot accept any.
#include <arpa/inet.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/resource.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "tests/e2e/daemon_process.h"
#include "tests/e2e/raw_client.h"
#include "tests/e2e/timeout.h"

namespace hedgehog::e2e {
namespace {

/// A connection that is reset at once.
void connect_and_reset(int port) {
  const int fd = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_port = htons(static_cast<std::uint16_t>(port));
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  EXPECT_EQ(::connect(fd, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  const linger at_once{1, 0};
  ::setsockopt(fd, SOL_SOCKET, SO_LINGER, &at_once, sizeof at_once);
  ::close(fd);
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t found = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++found;
  return found;
}

TEST(Accept, AConnectionResetBeforehandIsNoClient) {
  const Home home;
  const DaemonProcess daemon(home, {}, {}, DaemonProcess::Backend::kFree);
  ASSERT_EQ(RawClient(daemon.port()).call("hello")["connection"], 1);
  daemon.signal(SIGSTOP);
  for (int i = 0; i < 5; ++i) connect_and_reset(daemon.port());
  daemon.signal(SIGCONT);
  EXPECT_EQ(RawClient(daemon.port()).call("hello")["connection"], 2);
  EXPECT_THAT(daemon.log(), testing::Not(testing::HasSubstr("0.0.0.0")));
}

TEST(Accept, ExhaustedDescriptorsAreReportedOnceAndLaterClientsAccepted) {
  const Home home;
  const DaemonProcess daemon(home);
  RawClient early(daemon.port());
  const std::int64_t before_ns = early.call("ping")["time_ns"];
  rlimit limit{};
  ASSERT_EQ(::prlimit(daemon.pid(), RLIMIT_NOFILE, nullptr, &limit), 0);
  const std::filesystem::path open = "/proc/" + std::to_string(daemon.pid()) + "/fd";
  const auto used = std::distance(std::filesystem::directory_iterator(open), {});
  const rlimit none{static_cast<rlim_t>(used), limit.rlim_max};
  ASSERT_EQ(::prlimit(daemon.pid(), RLIMIT_NOFILE, &none, nullptr), 0);
  RawClient tcp(daemon.port());
  RawClient local(daemon.socket());
  EXPECT_TRUE(daemon.logs("cannot accept clients: "));
  // Ten accept attempts later.
  EXPECT_TRUE(wait_until([&] {
    return early.call("ping")["time_ns"].get<std::int64_t>() > before_ns + 1'000'000'000;
  }));
  EXPECT_EQ(count(daemon.log(), "cannot accept clients: "), 1u);
  ASSERT_EQ(::prlimit(daemon.pid(), RLIMIT_NOFILE, &limit, nullptr), 0);
  EXPECT_TRUE(tcp.call("ping").contains("time_ns"));
  EXPECT_TRUE(local.call("ping").contains("time_ns"));
}

}  // namespace
}  // namespace hedgehog::e2e
