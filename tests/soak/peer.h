// SPDX-License-Identifier: MIT
// One non-blocking client of the daemon: it sends, reads or does not read, and disconnects in
// several ways. It records the sent messages and the responses that they require.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/wire/json.h"
#include "tests/soak/framing.h"
#include "tests/soak/pending_responses.h"
#include "tests/soak/subscriptions.h"

namespace hedgehog::soak {

struct Endpoints {
  int port = 0;
  int http_port = 0;
  std::string socket;
};

class Peer;

/// Receives the messages once they have been checked.
class PeerObserver {
 public:
  virtual ~PeerObserver() = default;
  virtual void on_response(Peer& peer, const CompletedRequest& completed) = 0;
  virtual void on_notification(Peer& peer, const protocol::Json& message) = 0;
};

class Peer {
 public:
  /// Connects. `receive_buffer`: size of the socket's receive buffer in bytes, 0: the system's
  /// default.
  Peer(Transport transport, const Endpoints& endpoints, int receive_buffer);
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  ~Peer() { close(); }

  /// Sends one message and expects the response that it requires. `fragments`: of its WebSocket
  /// frame.
  void send(const std::string& message, int fragments = 1);
  /// Sends the first part of a line; the rest precedes whatever is sent next.
  void send_in_parts(const std::string& line, std::size_t first);
  /// Sends a message of more than 64 KiB.
  void send_too_long(std::size_t bytes);
  /// Sends raw bytes; no response is expected.
  void send_bytes(std::string_view bytes);
  /// Sends the rest of a line that was sent in part.
  void complete_line();

  /// Shuts down the sending side. The responses are still expected.
  void half_close();
  void close();
  /// Closes with a TCP reset.
  void reset();

  /// From now on the daemon may close the connection, for the reason `why`.
  void allow_close(std::string why) { close_reason_ = std::move(why); }
  const std::string& close_reason() const noexcept { return close_reason_; }

  /// Reads and writes without blocking.
  void exchange(bool readable, bool writable, PeerObserver& observer);
  bool can_write() const noexcept {
    return is_open() && !(is_upgrading() ? handshake_ : out_).empty();
  }
  bool can_read() const noexcept { return is_open() && reads_; }
  void read(bool on) noexcept { reads_ = on; }
  bool reads() const noexcept { return reads_; }

  int fd() const noexcept { return fd_; }
  bool is_open() const noexcept { return fd_ >= 0; }
  /// True if the daemon has closed or reset the connection.
  bool is_closed_by_daemon() const noexcept { return closed_by_daemon_; }
  bool is_half_closed() const noexcept { return half_closed_; }
  bool is_partial() const noexcept { return !rest_.empty(); }
  Transport transport() const noexcept { return transport_; }
  std::size_t pending() const noexcept { return responses_.size(); }
  std::size_t unsent_bytes() const noexcept { return out_.size(); }
  bool has_received() const noexcept { return received_; }
  /// The daemon's number of this connection, once known.
  std::optional<std::int64_t> number() const noexcept { return number_; }
  /// The name in the daemon's log; empty for a Unix socket.
  const std::string& address() const noexcept { return address_; }
  /// For a report: the last message sent, and the missing responses.
  std::string text() const;

 private:
  /// A WebSocket's frames are held until the response to its handshake (RFC 6455, section 4.1).
  bool is_upgrading() const noexcept {
    return transport_ == Transport::kWebSocket && unframer_.status() == 0;
  }
  void connect(const Endpoints& endpoints, int receive_buffer);
  void record(const std::string& sent);
  void receive(const Received& message, PeerObserver& observer);
  void read_some(PeerObserver& observer);
  void write_some();
  void shut_down_when_sent();

  Transport transport_;
  int fd_ = -1;
  std::string address_;
  Unframer unframer_;
  std::string handshake_;
  std::string out_;
  std::string rest_;  // of a partly sent line, without its LF
  std::string part_;  // the first part of the same line
  PendingResponses responses_;
  Subscriptions subscriptions_;
  std::optional<std::int64_t> number_;
  std::string close_reason_;
  std::deque<std::string> transcript_;
  bool reads_ = true;
  bool received_ = false;
  bool half_closed_ = false;
  bool shut_down_ = false;  // the socket has been shut down for sending
  bool closed_by_daemon_ = false;
};

}  // namespace hedgehog::soak
