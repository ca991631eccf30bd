// SPDX-License-Identifier: MIT
// One client connection: reads requests, writes responses and notifications. Owns itself through
// its coroutines. io thread only.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/steady_timer.hpp>
#include <boost/system/error_code.hpp>
#include <chrono>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>

#include "daemon/server/rpc/server.h"
#include "daemon/server/session/session.h"
#include "daemon/server/session/write_queue.h"

namespace hedgehog::server {

class Connection : public Sink, public std::enable_shared_from_this<Connection> {
 public:
  /// Bytes read from a socket at a time.
  static constexpr std::size_t kReadBytes = 16 * 1024;

  /// Starts its coroutines.
  void start();
  /// Sends what waits (1 s at most), then closes.
  void finish() override;

  void send(std::string line, LineKind kind) override;

  const Session& session() const noexcept { return session_; }

 protected:
  /// `session`: transport, address and role are filled in.
  Connection(boost::asio::any_io_executor executor, Server& server, Session session,
             std::size_t queue_bytes);

  /// Passes what arrives to `take` and `too_long` until the client closes its end.
  virtual boost::asio::awaitable<void> read() = 0;
  /// Sends what is next in the queue.
  virtual boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) = 0;
  /// Everything has been sent.
  virtual boost::asio::awaitable<void> finish_stream() = 0;
  /// At once; what still runs on the socket ends with an error. A second call does nothing.
  virtual void close() noexcept = 0;

  /// The client has closed the connection, though its socket is still open.
  void on_client_close() { server_.close(session_); }
  /// Something has arrived: its turn begins.
  void begin_turn() noexcept;
  /// Carries out one message; when the turn is over the others get theirs first. False: the client
  /// has to go.
  boost::asio::awaitable<bool> take(std::string_view text);
  boost::asio::awaitable<bool> too_long();
  std::int64_t id() const noexcept { return session_.id; }
  Counters& counters() noexcept { return server_.counters(); }

 private:
  boost::asio::awaitable<void> run();
  boost::asio::awaitable<void> write();
  boost::asio::awaitable<bool> next_turn();
  void abort() noexcept;

  boost::asio::any_io_executor executor_;
  Server& server_;
  Session session_;
  WriteQueue queue_;
  boost::asio::steady_timer wake_;
  boost::asio::steady_timer pending_timer_;  // waits until no response is pending
  boost::asio::steady_timer close_timer_;
  std::chrono::steady_clock::time_point turn_ends_{};
  bool finishing_ = false;
  bool aborted_ = false;
};

}  // namespace hedgehog::server
