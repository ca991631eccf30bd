// SPDX-License-Identifier: MIT
// A TCP connection, with TLS or without, as one type, so that Boost.Beast's HTTP and WebSocket,
// which take long to compile, are compiled only once. For source files with Beast only.
#pragma once

#include <array>
#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/async_result.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/buffer.hpp>
#include <boost/asio/co_spawn.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/role.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/system/error_code.hpp>
#include <chrono>
#include <cstddef>
#include <exception>
#include <memory>
#include <utility>

#include "daemon/server/net/tls_context.h"

namespace hedgehog::server {

/// Type-erased handler of a read or write. Called once, on the stream's executor.
class TransferHandler {
 public:
  template <class Handler>
  explicit TransferHandler(Handler handler)
      : handler_(std::make_unique<Of<Handler>>(std::move(handler))) {}

  void operator()(boost::system::error_code ec, std::size_t count) {
    std::exchange(handler_, nullptr)->call(ec, count);
  }

 private:
  struct Any {
    virtual ~Any() = default;
    virtual void call(boost::system::error_code ec, std::size_t count) = 0;
  };
  template <class Handler>
  struct Of final : Any {
    explicit Of(Handler given) : handler(std::move(given)) {}
    void call(boost::system::error_code ec, std::size_t count) override {
      std::move(handler)(ec, count);
    }
    Handler handler;
  };

  std::unique_ptr<Any> handler_;
};

/// Beast's AsyncStream. One read and one write at a time; io thread.
class HttpStream {
 public:
  using executor_type = boost::asio::any_io_executor;
  /// Buffers of one write: header and body of a response are sent together; Beast has a buffer for
  /// each field.
  using Gathered = std::array<boost::asio::const_buffer, 32>;
  static constexpr std::chrono::seconds kEndTimeout{1};

  explicit HttpStream(boost::asio::ip::tcp::socket socket);
  /// With TLS; call `handshake` first.
  HttpStream(boost::asio::ip::tcp::socket socket, const TlsContext& context);

  executor_type get_executor() noexcept { return transport_->tcp().get_executor(); }
  bool is_tls() const noexcept { return tls_; }
  boost::asio::ip::tcp::socket& socket() noexcept { return transport_->tcp().socket(); }
  /// Timeout of reads, writes, `handshake` and `end`.
  void expires_after(std::chrono::seconds timeout) { transport_->tcp().expires_after(timeout); }
  void expires_never() { transport_->tcp().expires_never(); }

  /// The server's handshake; does nothing without TLS.
  boost::asio::awaitable<boost::system::error_code> handshake() { return transport_->handshake(); }
  /// Closes the sending direction. Without TLS it reads the data still sent by the client: unread
  /// bytes would reset the connection before the client has read its response.
  boost::asio::awaitable<boost::system::error_code> end() { return transport_->end(); }

  template <class Buffers, class Token>
  auto async_read_some(const Buffers& buffers, Token&& token) {
    boost::asio::mutable_buffer into;
    for (auto at = boost::asio::buffer_sequence_begin(buffers);
         into.size() == 0 && at != boost::asio::buffer_sequence_end(buffers); ++at)
      into = *at;
    return boost::asio::async_initiate<Token, Transferred>(
        [](auto handler, Transport* transport, boost::asio::mutable_buffer buffer) {
          transport->read(buffer, TransferHandler(std::move(handler)));
        },
        token, transport_.get(), into);
  }

  template <class Buffers, class Token>
  auto async_write_some(const Buffers& buffers, Token&& token) {
    Gathered gathered;
    auto next = gathered.begin();
    for (auto at = boost::asio::buffer_sequence_begin(buffers);
         next != gathered.end() && at != boost::asio::buffer_sequence_end(buffers); ++at)
      *next++ = *at;
    return boost::asio::async_initiate<Token, Transferred>(
        [](auto handler, Transport* transport, const Gathered& all) {
          transport->write(all, TransferHandler(std::move(handler)));
        },
        token, transport_.get(), gathered);
  }

 private:
  using Transferred = void(boost::system::error_code, std::size_t);
  struct Transport {
    virtual ~Transport() = default;
    virtual boost::beast::tcp_stream& tcp() noexcept = 0;
    virtual void read(boost::asio::mutable_buffer buffer, TransferHandler handler) = 0;
    virtual void write(const Gathered& buffers, TransferHandler handler) = 0;
    virtual boost::asio::awaitable<boost::system::error_code> handshake() = 0;
    virtual boost::asio::awaitable<boost::system::error_code> end() = 0;
  };
  struct PlainTransport;
  struct TlsTransport;

  std::unique_ptr<Transport> transport_;
  bool tls_;
};

// Required of a stream by Beast's WebSocket: to end it, and to close it after a timeout.
template <class Handler>
void async_teardown(boost::beast::role_type /*always the server*/, HttpStream& stream,
                    Handler&& handler) {
  stream.expires_after(HttpStream::kEndTimeout);
  boost::asio::co_spawn(stream.get_executor(), stream.end(),
                        [handler = std::forward<Handler>(handler)](
                            const std::exception_ptr&, boost::system::error_code ec) mutable {
                          std::move(handler)(ec);
                        });
}
void beast_close_socket(HttpStream& stream);

}  // namespace hedgehog::server
