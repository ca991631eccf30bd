// SPDX-License-Identifier: MIT
// TLS 1.3 to a daemon whose certificate is verified by its fingerprint, or by the authorities that
// the system trusts. For the implementation of sockets only: line_socket.cpp, and the tunnel of
// hedgehogctl.
#pragma once

#include <boost/asio/generic/stream_protocol.hpp>
#include <boost/asio/ssl/context.hpp>
#include <boost/asio/ssl/stream.hpp>
#include <optional>
#include <string>
#include <utility>

#include "clients/lib/address.h"

namespace hedgehog::client {

/// Over a connected socket, which must outlive it.
class TlsStream {
 public:
  using Socket = boost::asio::generic::stream_protocol::socket;

  /// Throws boost::system::system_error when OpenSSL fails.
  TlsStream(Socket& socket, const Address& address);

  /// `token`: a completion token of Asio, for an error_code.
  template <class Token>
  auto async_handshake(Token&& token) {
    return stream_.async_handshake(boost::asio::ssl::stream_base::client,
                                   std::forward<Token>(token));
  }
  /// After the handshake, before anything is sent: why the peer is not the daemon that `address`
  /// means; empty: it is trusted.
  std::string verify_problem();
  boost::asio::ssl::stream<Socket&>& stream() noexcept { return stream_; }

 private:
  std::optional<base::Sha256> fingerprint_;
  boost::asio::ssl::context context_;
  boost::asio::ssl::stream<Socket&> stream_;
};

}  // namespace hedgehog::client
