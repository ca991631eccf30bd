// SPDX-License-Identifier: MIT
// A client on TCP, with TLS or without, or on the Unix socket: one message per line.
#pragma once

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <type_traits>

#include "daemon/server/net/connection.h"
#include "daemon/server/net/line_reader.h"

namespace hedgehog::server {

/// `Stream`: a socket, or a TLS stream after its handshake.
template <class Stream>
class BasicLineConnection final : public Connection {
 public:
  BasicLineConnection(Stream stream, Server& server, Session session,
                      const config::ConnectionSettings& settings)
      : Connection(stream.get_executor(), server, std::move(session), settings),
        stream_(std::move(stream)) {
    // For `send_now` and `read_available`; asynchronous operations are not affected.
    boost::system::error_code ignored;
    if constexpr (kPlain) stream_.non_blocking(true, ignored);
  }

 private:
  using Socket = boost::asio::generic::stream_protocol::socket;
  static constexpr bool kPlain = std::is_same_v<Stream, Socket>;

  boost::asio::awaitable<void> read() override;
  boost::asio::awaitable<boost::system::error_code> send_next(WriteQueue& queue) override;
  void send_now(WriteQueue& queue) override;
  boost::asio::awaitable<void> finish_stream() override;
  void close() noexcept override;
  std::size_t unread_bytes() noexcept override;
  /// Reads what a plain socket has received, up to `kReadBytes`. False: no more will follow.
  bool read_available(LineReader& reader);
  void take_line(const LineReader::Line& line);

  Stream stream_;
};

using LineConnection = BasicLineConnection<boost::asio::generic::stream_protocol::socket>;
using TlsStream = boost::asio::ssl::stream<boost::asio::ip::tcp::socket>;
using TlsLineConnection = BasicLineConnection<TlsStream>;
extern template class BasicLineConnection<boost::asio::generic::stream_protocol::socket>;
extern template class BasicLineConnection<TlsStream>;

}  // namespace hedgehog::server
