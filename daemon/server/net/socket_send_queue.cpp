// SPDX-License-Identifier: MIT
#include "daemon/server/net/socket_send_queue.h"

#include <sys/ioctl.h>

#include <algorithm>

namespace hedgehog::server {

std::size_t socket_send_queue(int fd) noexcept {
  int bytes = 0;
  // TIOCOUTQ is SIOCOUTQ.
  if (::ioctl(fd, TIOCOUTQ, &bytes) != 0) return 0;
  return static_cast<std::size_t>(std::max(bytes, 0));
}

}  // namespace hedgehog::server
