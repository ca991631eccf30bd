// SPDX-License-Identifier: MIT
// The socket of the participant's page belongs to one run of a study's folder.
#include "clients/study/session/participant_page.h"

#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <sysexits.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "tests/temporary_folder.h"

namespace hedgehog::study {
namespace {

/// Leaves a socket at `path` that nothing listens to, as a killed run does.
void leave_socket(const std::string& path) {
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  const int socket = ::socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  ASSERT_EQ(::bind(socket, reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  ::close(socket);
}

TEST(ParticipantServer, DoesNotTakeTheSocketOfAnotherRun) {
  const TemporaryFolder folder;
  const std::string path = folder.path("participant.sock");
  {
    const auto first = ParticipantServer::listen(path);
    ASSERT_TRUE(first);
    for (int i = 0; i < 6; ++i) {
      const auto second = ParticipantServer::listen(path);
      ASSERT_FALSE(second) << "the first one still listens there";
      EXPECT_EQ(second.error().exit_code, EX_CANTCREAT);
      EXPECT_EQ(second.error().message, path + ": another run in this folder has it");
    }
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_TRUE(ParticipantServer::listen(path));
}

TEST(ParticipantServer, ReplacesTheSocketOfAKilledRun) {
  const TemporaryFolder folder;
  const std::string path = folder.path("participant.sock");
  leave_socket(path);
  ASSERT_TRUE(std::filesystem::exists(path));
  EXPECT_TRUE(ParticipantServer::listen(path));
}

}  // namespace
}  // namespace hedgehog::study
