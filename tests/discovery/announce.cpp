// SPDX-License-Identifier: MIT
// announce NAME PORT SERIAL: announces a ball with these properties until SIGTERM.
#include <csignal>
#include <cstdlib>

#include "daemon/announcement.h"

int main(int argc, char** argv) {
  if (argc != 4) return EXIT_FAILURE;
  sigset_t end;
  sigemptyset(&end);
  sigaddset(&end, SIGTERM);
  // Before the announcement starts its thread, which inherits the mask.
  pthread_sigmask(SIG_BLOCK, &end, nullptr);
  const hedgehog::daemon::Announcement announcement(
      {argv[1], static_cast<std::uint16_t>(std::atoi(argv[2])), argv[3], "1.0"});
  int signal = 0;
  sigwait(&end, &signal);
  return EXIT_SUCCESS;
}
