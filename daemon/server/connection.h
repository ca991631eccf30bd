// SPDX-License-Identifier: MIT
// One client's socket: reads lines, writes lines, and ends with its client. Kept alive by its own
// coroutines. io thread only.
#pragma once

#include <boost/asio/awaitable.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/steady_timer.hpp>
#include <memory>
#include <string>

#include "daemon/server/server.h"
#include "daemon/server/session.h"
#include "daemon/server/write_queue.h"

namespace hedgehog::server {

class Connection final : public Sink, public std::enable_shared_from_this<Connection> {
 public:
  using Socket = boost::asio::generic::stream_protocol::socket;

  /// `session`: transport, address and role are filled in.
  Connection(Socket socket, Server& server, Session session, std::size_t queue_bytes);

  /// Starts its coroutines.
  void start();
  /// Sends what waits (1 s at most), then closes.
  void finish() override;

  void send(std::string line, LineKind kind) override;

  const Session& session() const noexcept { return session_; }

 private:
  boost::asio::awaitable<void> read();
  boost::asio::awaitable<void> write();
  /// Carries out what has arrived; lets the others have their turn in between. False: it has to go.
  boost::asio::awaitable<bool> take_lines(class LineReader& reader);
  void abort() noexcept;

  Socket socket_;
  Server& server_;
  Session session_;
  WriteQueue queue_;
  boost::asio::steady_timer wake_;
  boost::asio::steady_timer owed_;  // waits until no answer is owed any more
  boost::asio::steady_timer farewell_;
  bool finishing_ = false;
  bool aborted_ = false;
};

}  // namespace hedgehog::server
