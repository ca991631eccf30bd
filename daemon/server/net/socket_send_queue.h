// SPDX-License-Identifier: MIT
// Unsent data of a socket in the system. Any thread.
#pragma once

#include <cstddef>

namespace hedgehog::server {

/// Bytes written to socket `fd` that its peer has not received (TCP: not acknowledged); 0 if
/// unknown. The system has buffers of megabytes and signals writability only when a third of them
/// is free, so this distinguishes a slow reader from one that does not read. Source: tcp(7),
/// unix(7), SIOCOUTQ.
std::size_t socket_send_queue(int fd) noexcept;

}  // namespace hedgehog::server
