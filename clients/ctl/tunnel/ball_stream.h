// SPDX-License-Identifier: MIT
// The connection of a tunnel to the ball: TLS to a verified daemon, which has accepted the token.
#pragma once

#include <boost/asio/any_io_executor.hpp>
#include <boost/asio/awaitable.hpp>
#include <boost/asio/generic/stream_protocol.hpp>
#include <memory>
#include <string>
#include <vector>

#include "clients/ctl/tunnel/deadline.h"
#include "clients/lib/address.h"
#include "clients/lib/client_error.h"
#include "clients/lib/tls_stream.h"

namespace hedgehog::client {

/// One connection. A network that is lost ends it after 15 s. io thread only.
class BallStream : public std::enable_shared_from_this<BallStream> {
 public:
  using Opened = Outcome<std::shared_ptr<BallStream>>;

  /// REQUIRES: each address has TLS and is not an mdns:// address (see `locate`).
  /// Connects to the first of `addresses` that accepts, within `response_timeout()` each beside the
  /// time in which the system's resolver finds a host's name, and sends its token, if it has one,
  /// in a hello. kNoDaemon: "no daemon answers at A (why)". kRefused: the token is unknown.
  static boost::asio::awaitable<Opened> open(const std::vector<Address>& addresses);

  BallStream(const boost::asio::any_io_executor& executor, const Address& address);
  BallStream(const BallStream&) = delete;
  BallStream& operator=(const BallStream&) = delete;

  boost::asio::ssl::stream<TlsStream::Socket&>& stream() noexcept { return tls_.stream(); }
  /// The daemon receives the end of the requests; its responses can still be read.
  void end_requests() noexcept;
  /// Pending operations end with an error. A second call does nothing.
  void close() noexcept;

 private:
  using Endpoint = boost::asio::generic::stream_protocol::endpoint;

  boost::asio::awaitable<Outcome<void>> connect_and_log_in(const Endpoint& endpoint);
  /// Empty: connected to the daemon that the address means; else why not.
  boost::asio::awaitable<std::string> connect(const Endpoint& endpoint);
  boost::asio::awaitable<Outcome<void>> log_in();
  std::string reason_of_end(const boost::system::error_code& error) const;

  Address address_;
  TlsStream::Socket socket_;
  TlsStream tls_;  // over `socket_`
  Deadline deadline_;
  bool timed_out_ = false;
};

}  // namespace hedgehog::client
