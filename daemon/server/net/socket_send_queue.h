// SPDX-License-Identifier: MIT
// What the system still has to send. Any thread.
#pragma once

#include <cstddef>

namespace hedgehog::server {

/// Bytes that were written to socket `fd` and that its peer has not taken (TCP: not acknowledged);
/// 0 when that cannot be known. The system has buffers of megabytes and tells a writer only when
/// a third of them is free, so this is how a slow reader is told from one that does not read.
/// Source: tcp(7), unix(7), SIOCOUTQ.
std::size_t socket_send_queue(int fd) noexcept;

}  // namespace hedgehog::server
