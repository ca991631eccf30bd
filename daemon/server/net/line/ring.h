// SPDX-License-Identifier: MIT
// Receives and sends of many sockets through io_uring: one system call for all ready clients, in
// place of two or three for each (its cost: tests/bench/goals.md). Source: io_uring(7),
// io_uring_setup(2), io_uring_enter(2).
#pragma once

#include <boost/asio/io_context.hpp>
#include <boost/asio/posix/stream_descriptor.hpp>
#include <boost/intrusive/list.hpp>
#include <cassert>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

namespace hedgehog::server {

/// io thread only, from `open` on.
class Ring {
 public:
  static constexpr std::size_t kReceiveBytes = 2048;  // at a time

  /// A receive or send of one socket, one at a time. Must outlive it, or the ring.
  class Operation : public boost::intrusive::list_base_hook<
                        boost::intrusive::link_mode<boost::intrusive::auto_unlink>> {
   public:
    Operation() = default;
    Operation(const Operation&) = delete;
    Operation& operator=(const Operation&) = delete;
    bool is_pending() const noexcept { return is_linked(); }  // started, not completed

   protected:
    ~Operation() { assert(!is_linked() || !submitted_); }

   private:
    friend class Ring;
    /// `result`: number of bytes, 0 at the end of the stream, or a negative errno. `data`: what was
    /// received; valid during the call. May start operations, and destroy this one.
    virtual void complete(int result, std::string_view data) = 0;
    /// The ring is destroyed: `complete` is not called. May destroy the operation.
    virtual void drop() noexcept = 0;

    enum class Kind : std::uint8_t { kReceive, kSend, kSendNow };
    Kind kind_ = Kind::kReceive;
    bool submitted_ = false;
    int socket_ = -1;
    std::string_view bytes_{};
  };

  /// nullptr: no io_uring of Linux 6.0, or it is forbidden; `reason`: a clause for display.
  static std::unique_ptr<Ring> open(boost::asio::io_context& io, std::string& reason);
  ~Ring();
  Ring(const Ring&) = delete;
  Ring& operator=(const Ring&) = delete;

  /// Receives up to `kReceiveBytes` once there is something. To end it early: shutdown(2).
  void receive(int socket, Operation& operation);
  /// Sends `bytes`, which must stay valid, once the socket takes some of them.
  void send(int socket, std::string_view bytes, Operation& operation);
  /// The same, but fails with -EAGAIN if the socket takes nothing at present.
  void send_now(int socket, std::string_view bytes, Operation& operation);
  /// Takes back an operation that the kernel has not got yet. False: it has.
  [[nodiscard]] bool withdraw(Operation& operation) noexcept;
  /// Completes a send that the kernel has done, without waiting for its turn. False: it has not.
  [[nodiscard]] bool settle(Operation& send);

 private:
  using Clock = std::chrono::steady_clock;
  using Operations = boost::intrusive::list<Operation, boost::intrusive::constant_time_size<false>>;
  struct Kernel;

  Ring(boost::asio::io_context& io, std::unique_ptr<Kernel> kernel);
  void wait_for_completions();
  /// Submits and completes operations until none is left, or others on the io thread are due.
  void run();
  void run_soon();
  /// Returns after `until`, once something was started.
  void take_completions(Clock::time_point until);
  bool has_work() const noexcept;
  void start(Operation& operation, Operation::Kind kind, int socket, std::string_view bytes);
  /// As many of those started as there are entries for.
  void submit();

  boost::asio::io_context& io_;
  std::unique_ptr<Kernel> kernel_;
  boost::asio::posix::stream_descriptor descriptor_;  // the kernel's; not closed by it
  Operations started_{};
  Operations submitted_{};
  bool running_ = false;
  bool scheduled_ = false;
};

}  // namespace hedgehog::server
