// SPDX-License-Identifier: MIT
// One client connection: reads requests, writes responses and notifications. While too many
// responses are unsent, requests are held in order, except for an emergency stop; with too many
// held ones reading pauses. Owns itself through its coroutines. io thread only.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/system/error_code.hpp>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <list>
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
  static constexpr std::size_t kReadBytes = 16 * 1024;  // at most, of one read from a socket
  /// Requests that wait for a tick or for the disk; with more, further ones are held. With twice as
  /// many, possible only for emergency stops, reading pauses.
  static constexpr std::size_t kMaxPending = 64;

  void start();
  /// Sends the queue (1 s at most), then closes.
  void finish() override;

  void send(std::string line, LineKind kind) override;
  void send_telemetry(const SharedLine& line) override;
  void flush(Flush when) override;

  const Session& session() const noexcept { return session_; }
  /// `ticket` is released after the log-in.
  void set_half_open(HalfOpen::Ticket ticket) noexcept { ticket_ = std::move(ticket); }

 protected:
  /// `session`: transport, address and role are set.
  Connection(boost::asio::any_io_executor executor, Server& server, Session session,
             const config::ConnectionSettings& settings);

  /// Passes received data to `take` and `too_long` until the client closes its end.
  virtual boost::asio::awaitable<void> read() = 0;
  /// Sends the next lines of the queue; reports each part that was written to the socket.
  virtual boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) = 0;
  /// Writes what is possible without waiting, or starts to (kSoon): `sent_now` then reports the
  /// result. False: `send_next` handles an error or the rest, for some streams all of it.
  virtual bool send_now(WriteQueue&, Flush) { return false; }
  /// The first `bytes` of what `send_now` took were sent; if not all, `send_next` continues.
  void sent_now(std::size_t bytes);
  /// Called after everything has been sent.
  virtual boost::asio::awaitable<void> finish_stream() = 0;
  /// Closes at once; pending operations end with an error. A second call does nothing.
  virtual void close() noexcept = 0;
  /// Bytes written to the socket that the client has not received yet.
  virtual std::size_t unread_bytes() noexcept = 0;

  /// The client sends no more, though its socket may still be open: its effects end.
  void on_client_close();
  void on_sent_part();
  void close_socket() noexcept;  // also releases the ticket
  /// Data was received: its turn starts. The responses are sent together at the end of the turn.
  void on_received() noexcept;
  void end_turn();
  /// Executes one message, or holds it.
  void take(std::string_view text);
  void too_long();
  /// To be checked after each message: false while the turn may continue.
  bool must_pause() const noexcept;
  /// Lets other clients run; waits while no more can be held. False: disconnect the client.
  boost::asio::awaitable<bool> pause();
  std::int64_t id() const noexcept { return session_.id; }
  const boost::asio::any_io_executor& executor() const noexcept { return executor_; }
  Counters& counters() noexcept { return server_.counters(); }

 private:
  struct Held {
    std::string text;
    bool too_long = false;
    std::int64_t received_ns = 0;
    /// With that of its place in the list.
    std::size_t bytes() const noexcept { return text.size() + sizeof *this + 4 * sizeof(void*); }
  };

  boost::asio::awaitable<void> run();
  boost::asio::awaitable<void> write();
  /// Executes held requests as the client reads; after `write_timeout_s` without reading, closes.
  boost::asio::awaitable<void> serve_held();
  boost::asio::awaitable<void> serve_all();
  /// Starts `serve_held` unless it runs: on a held request, on `held_back`, after the last request.
  void serve();
  void serve_next();
  void execute(std::string_view text, std::int64_t received_ns);
  boost::asio::awaitable<void> wait_for_reader();
  void begin_turn(
      std::chrono::steady_clock::time_point now = std::chrono::steady_clock::now()) noexcept;
  boost::asio::awaitable<void> yield_turn();
  /// Called after a line was queued; `fits`: the queue was not full.
  void on_queued(bool fits, LineKind kind);
  /// True: the end of the turn, or the server's pump, will flush.
  bool defer_flush() { return in_turn_ || server_.flush_after_pump(session_, queue_.bytes()); }
  void hold(Held line);
  /// Executes `text` before the held requests, which may start nothing afterwards.
  void bypass_held(std::string_view text);
  bool must_hold() const noexcept { return !held_.empty() || held_back(); }
  bool held_back() const noexcept;  // too many responses are unsent or pending
  bool held_back_by_bytes() const noexcept {
    return queue_.response_bytes() + session_.open_bytes > allowed_response_bytes();
  }
  /// After the last request the client must read all of them.
  std::size_t allowed_response_bytes() const noexcept {
    return read_ended_ && held_.empty() ? 0 : held_back_bytes_;
  }
  bool full() const noexcept;  // no more requests can be held
  void report_not_reading();
  void abort() noexcept;

  boost::asio::any_io_executor executor_;
  Server& server_;
  Session session_;
  HalfOpen::Ticket ticket_{};
  WriteQueue queue_;
  /// Limit of unsent responses; the queue has capacity for a whole batch beyond it.
  std::size_t held_back_bytes_;
  std::size_t max_held_bytes_;  // without the last of the held requests
  std::list<Held> held_{};      // uses no memory while it is empty
  std::size_t held_bytes_ = 0;
  std::chrono::seconds write_timeout_;
  boost::asio::steady_timer wake_;
  boost::asio::steady_timer progress_;       // cancelled when something was sent or answered
  boost::asio::steady_timer capacity_;       // waits until it is not `full`, or not `serving_`
  boost::asio::steady_timer pending_timer_;  // waits until no response is pending
  boost::asio::steady_timer close_timer_;
  std::chrono::steady_clock::time_point turn_ends_{};
  std::int64_t received_ns_ = 0;
  bool in_turn_ = false;
  bool writing_ = false;  // `write` is not waiting for lines to send
  bool finishing_ = false;
  bool aborted_ = false;
  bool sent_part_ = false;  // since the start of the write timeout
  bool write_ended_ = false;
  bool read_ended_ = false;
  bool serving_ = false;  // `serve_held` runs
  bool served_ = false;   // all requests of a client that sends no more
};

}  // namespace hedgehog::server
