// SPDX-License-Identifier: MIT
// Lines on a plain socket, received and sent through a `Ring`.
#pragma once

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/use_awaitable.hpp>
#include <memory>
#include <optional>
#include <string_view>

#include "daemon/server/net/line/line_connection.h"
#include "daemon/server/net/line/ring.h"

namespace hedgehog::server {

class RingConnection final : public LineConnection {
 public:
  using Socket = boost::asio::generic::stream_protocol::socket;

  /// `ring` must outlive the reads and writes, or end them by its destruction.
  RingConnection(Socket socket, Ring& ring, Server& server, Session session,
                 const config::ConnectionSettings& settings);
  ~RingConnection() override;

 private:
  /// An operation that a coroutine waits for.
  class Awaited final : public Ring::Operation {
   public:
    struct Result {
      int count;  // of bytes, or a negative errno
      std::string_view data;
    };
    /// `start` starts it. The result's data is valid until the next suspension.
    template <class Start>
    boost::asio::awaitable<Result> run(Start start);

   private:
    using Token = boost::asio::use_awaitable_t<>;
    using Handler = boost::asio::async_result<Token, void(Result)>::handler_type;
    void complete(int result, std::string_view data) override;
    void drop() noexcept override;
    std::optional<Handler> handler_;
  };

  /// A send of what the socket takes at once. Keeps its connection while it is pending.
  class Immediate final : public Ring::Operation {
   public:
    explicit Immediate(RingConnection& connection) : connection_(connection) {}
    void start(std::string_view bytes);
    /// Takes it back, or completes it. False: it is pending, because the kernel is doing it.
    [[nodiscard]] bool finish();

   private:
    void complete(int result, std::string_view) override;
    void drop() noexcept override { kept_.reset(); }
    RingConnection& connection_;
    std::shared_ptr<Connection> kept_{};
  };

  boost::asio::awaitable<void> read() override;
  boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) override;
  bool send_now(WriteQueue& queue, Flush when) override;
  boost::asio::awaitable<void> finish_stream() override { co_return; }
  /// Ends the receive and a send that waits; the destructor frees the descriptor, whose number the
  /// operations refer to.
  void close() noexcept override;
  std::size_t unread_bytes() noexcept override;

  Ring& ring_;
  int socket_;
  bool closed_ = false;
  Awaited receive_{};
  Awaited send_{};
  Immediate send_now_{*this};
};

}  // namespace hedgehog::server
