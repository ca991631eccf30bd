// SPDX-License-Identifier: MIT
// One client connection: reads requests, writes responses and notifications. While many responses
// wait to be taken, requests are held, and when enough of them are, no more are read: a client may
// send as many at once as it likes. What is held waits in order, but an emergency stop does not.
// Owns itself through its coroutines. io thread only.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/system/error_code.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <string>
#include <string_view>

#include "daemon/config/config.h"
#include "daemon/server/net/half_open.h"
#include "daemon/server/rpc/server.h"
#include "daemon/server/session/session.h"
#include "daemon/server/session/write_queue.h"

namespace hedgehog::server {

class Connection : public Sink, public std::enable_shared_from_this<Connection> {
 public:
  /// Bytes read from a socket at a time.
  static constexpr std::size_t kReadBytes = 16 * 1024;
  /// Requests that wait for a tick or for the disk; with more, further ones are held. With twice as
  /// many, which only emergency stops can be, nothing is read.
  static constexpr std::size_t kMaxPending = 64;

  /// Starts its coroutines.
  void start();
  /// Sends what waits (1 s at most), then closes.
  void finish() override;

  void send(std::string line, LineKind kind) override;
  void send_telemetry(const SharedLine& line) override;

  const Session& session() const noexcept { return session_; }
  /// `ticket` is given up once it has logged in.
  void set_half_open(HalfOpen::Ticket ticket) noexcept { ticket_ = std::move(ticket); }

 protected:
  /// `session`: transport, address and role are filled in.
  Connection(boost::asio::any_io_executor executor, Server& server, Session session,
             const config::ConnectionSettings& settings);

  /// Passes what arrives to `take` and `too_long` until the client closes its end.
  virtual boost::asio::awaitable<void> read() = 0;
  /// Sends what is next in the queue; reports each part of it that the socket took.
  virtual boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) = 0;
  /// Sends as much of the queue as the stream takes without waiting; errors and the rest are left
  /// to `send_next`. Nothing, unless the stream can do that.
  virtual void send_now(WriteQueue&) {}
  /// Everything has been sent.
  virtual boost::asio::awaitable<void> finish_stream() = 0;
  /// At once; what still runs on the socket ends with an error. A second call does nothing.
  virtual void close() noexcept = 0;
  /// Bytes that the socket took and the client did not yet.
  virtual std::size_t untaken_bytes() noexcept = 0;

  /// The client says no more, though its socket may still be open: what it plays ends.
  void on_client_close();
  void on_sent_part();
  /// Something has arrived: its turn begins. Its responses are sent together at the end of it.
  void on_received() noexcept;
  void end_turn();
  /// Carries out one message, or holds it.
  void take(std::string_view text);
  void too_long();
  /// After each message: false while the turn goes on.
  bool has_to_pause() const noexcept;
  /// Gives the others their turn; while no more can be held, waits. False: the client has to go.
  boost::asio::awaitable<bool> pause();
  std::int64_t id() const noexcept { return session_.id; }
  Counters& counters() noexcept { return server_.counters(); }

 private:
  /// A line that waits.
  struct Held {
    std::string text;
    bool too_long = false;
    std::int64_t received_ns = 0;
  };

  boost::asio::awaitable<void> run();
  boost::asio::awaitable<void> write();
  /// Carries out what is held, as the client takes its responses. One that takes nothing for
  /// `write_timeout_s` meanwhile is disconnected.
  boost::asio::awaitable<void> serve_held();
  boost::asio::awaitable<void> serve_until_end();
  void serve_next();
  void carry_out(std::string_view text, std::int64_t received_ns);
  boost::asio::awaitable<void> wait_for_reader();
  void begin_turn() noexcept;
  boost::asio::awaitable<void> yield_turn();
  /// Sends what waits, now as far as that is possible; `write` does the rest.
  void flush();
  /// A line was put into the queue; `fits`: it was not full.
  void on_queued(bool fits, LineKind kind);
  void hold(Held line);
  /// Carries out `text` before what is held, which starts nothing after it.
  void overtake(std::string_view text);
  bool has_to_wait() const noexcept { return !held_.empty() || held_back(); }
  /// Too many responses wait to be sent, or are still to come.
  bool held_back() const noexcept;
  bool held_back_by_bytes() const noexcept {
    return queue_.answer_bytes() + session_.open_bytes > allowed_answer_bytes();
  }
  /// After the last request all of them are to be taken.
  std::size_t allowed_answer_bytes() const noexcept {
    return read_ended_ && held_.empty() ? 0 : held_back_bytes_;
  }
  /// Nothing more can be held.
  bool full() const noexcept;
  void report_not_reading();
  void abort() noexcept;
  void close_socket() noexcept;

  boost::asio::any_io_executor executor_;
  Server& server_;
  Session session_;
  HalfOpen::Ticket ticket_{};
  WriteQueue queue_;
  /// Of waiting responses. Beside them a whole batch still fits: half of the queue, one more answer
  /// and those that say `busy`.
  std::size_t held_back_bytes_;
  /// Of held requests, without the last of them.
  std::size_t max_held_bytes_;
  std::deque<Held> held_{};
  std::size_t held_bytes_ = 0;
  std::chrono::seconds write_timeout_;
  boost::asio::steady_timer wake_;
  boost::asio::steady_timer progress_;       // cancelled when something was sent, or answered
  boost::asio::steady_timer work_;           // waits until `serve_held` has something to do
  boost::asio::steady_timer capacity_;       // waits until it is not `full`, or all is served
  boost::asio::steady_timer pending_timer_;  // waits until no response is pending
  boost::asio::steady_timer close_timer_;
  std::chrono::steady_clock::time_point turn_ends_{};
  std::int64_t received_ns_ = 0;
  bool in_turn_ = false;
  bool writing_ = false;  // `write` is not waiting for something to send
  bool finishing_ = false;
  bool aborted_ = false;
  bool sent_part_ = false;  // since the client's time to take something began
  bool write_ended_ = false;
  bool read_ended_ = false;
  bool served_ = false;  // all that was held
};

}  // namespace hedgehog::server
