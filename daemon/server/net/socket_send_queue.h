// SPDX-License-Identifier: MIT
// Unsent data of a socket in the system. Any thread.
#pragma once

#include <cstddef>

namespace hedgehog::server {

/// Bytes written to socket `fd` that its peer has not received (TCP: not acknowledged); 0 if
/// unknown. Distinguishes a slow reader from one that does not read; writability needs a third of a
/// buffer of megabytes to be free. Source: tcp(7), unix(7), SIOCOUTQ.
std::size_t socket_send_queue(int fd) noexcept;

}  // namespace hedgehog::server
