// SPDX-License-Identifier: MIT
#include "emulator/host_session.h"

#include <sys/socket.h>

#include <algorithm>
#include <cerrno>
#include <utility>

namespace hedgehog::emulator {
namespace {

/// Limit of the send buffer for a host that does not read its responses.
constexpr std::size_t kMaxUnsent = std::size_t{1} << 20;

bool would_block() { return errno == EAGAIN || errno == EWOULDBLOCK || errno == EINTR; }

}  // namespace

HostSession::HostSession(EmulatedDevice& device, device::FileDescriptor socket)
    : device_(device), socket_(std::move(socket)) {
  device_.plugged();
}

void HostSession::ready() {
  flush();
  std::array<Byte, 4096> chunk;
  while (open_) {
    const ssize_t got = ::recv(socket_.get(), chunk.data(), chunk.size(), MSG_DONTWAIT);
    if (got > 0) {
      received_.insert(received_.end(), chunk.begin(), chunk.begin() + got);
    } else {
      if (got == 0 || !would_block()) open_ = false;
      break;
    }
  }
  while (open_ && take_message()) {
  }
  pump();
}

bool HostSession::take_message() {
  if (received_.size() < kTransferHead) return false;
  const auto message = decode_host_message(received_);
  if (!message) {
    open_ = false;
    return false;
  }
  const bool carries = message->kind == HostMessage::Kind::kSubmit && !message->in;
  const std::size_t whole = kTransferHead + (carries ? message->length : 0);
  if (received_.size() < whole) return false;
  const auto end = received_.begin() + static_cast<std::ptrdiff_t>(whole);
  Bytes data(received_.begin() + kTransferHead, end);
  received_.erase(received_.begin(), end);
  handle(*message, std::move(data));
  return true;
}

void HostSession::handle(const HostMessage& message, Bytes data) {
  if (message.kind == HostMessage::Kind::kUnlink) {
    unlink(message);
  } else if (message.endpoint == 0) {
    control(message, data);
  } else {
    auto& waiting = (message.in ? reads_ : writes_)[message.endpoint];
    waiting.push_back({message.sequence, message.length, std::move(data)});
    // Before the next message, to keep the order of writes and requests on endpoint 0.
    if (!message.in) answer_writes(message.endpoint, waiting);
  }
}

void HostSession::control(const HostMessage& message, const Bytes& data) {
  auto answer = device_.control(SetupPacket::of(message.setup), data);
  if (!answer) {
    send(encode_submitted(message.sequence, kTransferStalled, 0));
  } else if (message.in) {
    answer->resize(std::min<std::size_t>(answer->size(), message.length));
    send(encode_submitted(message.sequence, kTransferDone,
                          static_cast<std::uint32_t>(answer->size()), *answer));
  } else {
    send(encode_submitted(message.sequence, kTransferDone, message.length));
  }
}

void HostSession::unlink(const HostMessage& message) {
  std::size_t unlinked = 0;
  for (auto* waiting : {&reads_, &writes_}) {
    for (auto& [endpoint, transfers] : *waiting) {
      unlinked += std::erase_if(
          transfers, [&](const Transfer& t) { return t.sequence == message.victim; });
    }
  }
  send(encode_unlinked(message.sequence, unlinked > 0 ? kTransferUnlinked : kTransferDone));
}

void HostSession::pump() {
  for (auto& [endpoint, writes] : writes_) answer_writes(endpoint, writes);
  for (auto& [endpoint, reads] : reads_) {
    answer_reads(endpoint, reads);
    device_.set_pending_reads(endpoint, reads.size());
  }
}

void HostSession::answer_reads(std::uint8_t endpoint, std::deque<Transfer>& reads) {
  while (open_ && !reads.empty()) {
    const Transfer& read = reads.front();
    if (device_.halted(endpoint | kIn)) {
      send(encode_submitted(read.sequence, kTransferStalled, 0));
    } else {
      if (device_.silent()) return;
      auto packet = device_.take(endpoint);
      if (!packet) return;
      const bool fits = packet->size() <= read.length;
      if (!fits) packet->resize(read.length);
      send(encode_submitted(read.sequence, fits ? kTransferDone : kTransferTooLong,
                            static_cast<std::uint32_t>(packet->size()), *packet));
    }
    reads.pop_front();
  }
}

void HostSession::answer_writes(std::uint8_t endpoint, std::deque<Transfer>& writes) {
  while (open_ && !writes.empty()) {
    const Transfer& write = writes.front();
    if (device_.halted(endpoint)) {
      send(encode_submitted(write.sequence, kTransferStalled, 0));
    } else {
      if (device_.silent() || !device_.accepts(endpoint)) return;
      device_.out(endpoint, write.data);
      send(encode_submitted(write.sequence, kTransferDone, write.length));
    }
    writes.pop_front();
  }
}

void HostSession::send(const Bytes& bytes) {
  const bool empty = unsent_.empty();
  unsent_.insert(unsent_.end(), bytes.begin(), bytes.end());
  if (empty) flush();
  if (unsent_.size() > kMaxUnsent) open_ = false;
}

void HostSession::flush() {
  while (open_ && !unsent_.empty()) {
    const ssize_t sent =
        ::send(socket_.get(), unsent_.data(), unsent_.size(), MSG_DONTWAIT | MSG_NOSIGNAL);
    if (sent > 0) {
      unsent_.erase(unsent_.begin(), unsent_.begin() + sent);
    } else {
      if (!would_block()) open_ = false;
      return;
    }
  }
}

}  // namespace hedgehog::emulator
