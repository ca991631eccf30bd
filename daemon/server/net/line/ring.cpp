// SPDX-License-Identifier: MIT
#include "daemon/server/net/line/ring.h"

#include <liburing.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <boost/asio/post.hpp>
#include <cerrno>
#include <chrono>
#include <cstdlib>
#include <cstring>
#include <utility>

namespace hedgehog::server {
namespace {

namespace asio = boost::asio;

/// Operations passed in one system call, at most.
constexpr unsigned kEntries = 256;
/// Sends among them. The kernel does them, 5 us each, without giving up the processor to a control
/// loop that is due: with 16 its ticks were 40 us later (p99, 1,000 subscribers at 100 Hz).
constexpr int kSends = 8;
/// Results that are kept until they are taken; the kernel keeps further ones elsewhere.
constexpr unsigned kCompletions = 4096;
/// Buffers of received data, each of which is used until its data is taken; a power of two.
constexpr unsigned kBuffers = 128;
constexpr int kGroup = 0;
/// After this time others of the io thread are served, and what was started is submitted.
constexpr std::chrono::milliseconds kRunTime{1};

}  // namespace

/// What is shared with the kernel.
struct Ring::Kernel {
  Kernel() = default;
  Kernel(const Kernel&) = delete;
  Kernel& operator=(const Kernel&) = delete;
  ~Kernel() {
    if (is_open) io_uring_queue_exit(&ring);
    std::free(buffer_ring);
  }

  /// 0, or a negative errno.
  int open() {
    io_uring_params params{};
    // Operations are carried out when the io thread enters the kernel anyway: they do not interrupt
    // it. Deferred further (DEFER_TASKRUN), they would not wake who waits for the descriptor.
    params.flags = IORING_SETUP_SINGLE_ISSUER | IORING_SETUP_COOP_TASKRUN | IORING_SETUP_CQSIZE;
    params.cq_entries = kCompletions;
    if (const int error = io_uring_queue_init_params(kEntries, &ring, &params); error < 0)
      return error;
    is_open = true;
    const auto page = static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
    const std::size_t bytes = (kBuffers * sizeof(io_uring_buf) + page - 1) / page * page;
    buffer_ring = static_cast<io_uring_buf_ring*>(std::aligned_alloc(page, bytes));
    if (buffer_ring == nullptr) return -ENOMEM;
    io_uring_buf_ring_init(buffer_ring);
    io_uring_buf_reg registration{};
    registration.ring_addr = reinterpret_cast<std::uintptr_t>(buffer_ring);
    registration.ring_entries = kBuffers;
    registration.bgid = kGroup;
    if (const int error = io_uring_register_buf_ring(&ring, &registration, 0); error < 0)
      return error;
    for (unsigned id = 0; id < kBuffers; ++id) return_buffer(id);
    return 0;
  }

  void return_buffer(unsigned id) noexcept {
    io_uring_buf_ring_add(buffer_ring, buffers[id].data(), kReceiveBytes,
                          static_cast<std::uint16_t>(id), io_uring_buf_ring_mask(kBuffers), 0);
    io_uring_buf_ring_advance(buffer_ring, 1);
  }

  io_uring ring{};
  io_uring_buf_ring* buffer_ring = nullptr;
  std::array<std::array<char, kReceiveBytes>, kBuffers> buffers;
  bool is_open = false;
};

std::unique_ptr<Ring> Ring::open(asio::io_context& io, std::string& reason) {
  auto kernel = std::make_unique<Kernel>();
  if (const int error = kernel->open(); error < 0) {
    reason = strerrordesc_np(-error);
    return nullptr;
  }
  return std::unique_ptr<Ring>(new Ring(io, std::move(kernel)));
}

Ring::Ring(asio::io_context& io, std::unique_ptr<Kernel> kernel)
    : io_(io), kernel_(std::move(kernel)), descriptor_(io, kernel_->ring.ring_fd) {
  wait_for_completions();
}

Ring::~Ring() {
  descriptor_.release();
  kernel_.reset();
  for (Operations* list : {&started_, &submitted_}) {
    while (!list->empty()) {
      Operation& operation = list->front();
      list->pop_front();
      operation.drop();
    }
  }
}

void Ring::wait_for_completions() {
  descriptor_.async_wait(
      asio::posix::stream_descriptor::wait_read,
      [this](const boost::system::error_code& ec) {
        if (ec) return;
        run();
        wait_for_completions();
      });
}

void Ring::run_soon() {
  if (running_ || std::exchange(scheduled_, true)) return;
  asio::post(io_, [this] {
    scheduled_ = false;
    run();
  });
}

void Ring::run() {
  running_ = true;
  const auto until = Clock::now() + kRunTime;
  take_completions(until);
  do {
    submit();
    take_completions(until);
  } while (has_work() && Clock::now() < until);
  running_ = false;
  if (has_work()) run_soon();
}

bool Ring::has_work() const noexcept {
  // Entries are left when the kernel is short of memory.
  return !started_.empty() || io_uring_sq_ready(&kernel_->ring) > 0 ||
         io_uring_cq_ready(&kernel_->ring) > 0;
}

void Ring::submit() {
  for (int sends = 0; sends < kSends && !started_.empty();) {
    io_uring_sqe* const entry = io_uring_get_sqe(&kernel_->ring);
    if (entry == nullptr) break;
    Operation& operation = started_.front();
    const std::string_view bytes = operation.bytes_;
    if (operation.kind_ != Operation::Kind::kReceive) ++sends;
    switch (operation.kind_) {
      case Operation::Kind::kReceive:
        io_uring_prep_recv(entry, operation.socket_, nullptr, kReceiveBytes, 0);
        entry->ioprio |= IORING_RECVSEND_POLL_FIRST;
        entry->flags |= IOSQE_BUFFER_SELECT;
        entry->buf_group = kGroup;
        break;
      case Operation::Kind::kSend:
        io_uring_prep_send(entry, operation.socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        break;
      case Operation::Kind::kSendNow:
        io_uring_prep_send(entry, operation.socket_, bytes.data(), bytes.size(),
                           MSG_NOSIGNAL | MSG_DONTWAIT);
        break;
    }
    io_uring_sqe_set_data(entry, &operation);
    operation.submitted_ = true;
    started_.pop_front();
    submitted_.push_back(operation);
  }
  io_uring_submit_and_get_events(&kernel_->ring);
}

void Ring::take_completions(Clock::time_point until) {
  io_uring_cqe* entry = nullptr;
  for (unsigned left = kCompletions; left > 0 && io_uring_peek_cqe(&kernel_->ring, &entry) == 0;
       --left) {
    auto* const done = static_cast<Operation*>(io_uring_cqe_get_data(entry));
    const int result = entry->res;
    const unsigned flags = entry->flags;
    io_uring_cqe_seen(&kernel_->ring, entry);
    if (done == nullptr) continue;  // settled
    Operation& operation = *done;
    operation.unlink();
    if (result == -ENOBUFS && operation.kind_ == Operation::Kind::kReceive) {
      // Before those that have just received.
      operation.submitted_ = false;
      started_.push_front(operation);
    } else if ((flags & IORING_CQE_F_BUFFER) != 0) {
      const unsigned id = flags >> IORING_CQE_BUFFER_SHIFT;
      operation.complete(
          result, {kernel_->buffers[id].data(), static_cast<std::size_t>(std::max(result, 0))});
      kernel_->return_buffer(id);
    } else {
      operation.complete(result, {});
    }
    // What was started meanwhile is not held up by all others.
    if (!started_.empty() && Clock::now() > until) return;
  }
}

void Ring::start(Operation& operation, Operation::Kind kind, int socket, std::string_view bytes) {
  operation.kind_ = kind;
  operation.socket_ = socket;
  operation.bytes_ = bytes;
  operation.submitted_ = false;
  started_.push_back(operation);
  run_soon();
}

void Ring::receive(int socket, Operation& operation) {
  start(operation, Operation::Kind::kReceive, socket, {});
}

void Ring::send(int socket, std::string_view bytes, Operation& operation) {
  start(operation, Operation::Kind::kSend, socket, bytes);
}

void Ring::send_now(int socket, std::string_view bytes, Operation& operation) {
  start(operation, Operation::Kind::kSendNow, socket, bytes);
}

bool Ring::settle(Operation& send) {
  io_uring_cqe* entry = nullptr;
  unsigned head = 0;
  io_uring_for_each_cqe(&kernel_->ring, head, entry) {
    if (io_uring_cqe_get_data(entry) != &send) continue;
    entry->user_data = 0;
    send.unlink();
    send.complete(entry->res, {});
    return true;
  }
  return false;
}

bool Ring::withdraw(Operation& operation) noexcept {
  if (operation.submitted_) return false;
  operation.unlink();
  return true;
}

}  // namespace hedgehog::server
