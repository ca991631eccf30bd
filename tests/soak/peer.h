// SPDX-License-Identifier: MIT
// One client of the daemon that never blocks: it sends, reads or does not, and leaves as it likes.
// What it sends is known, and so is what it has to receive.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>
#include <string>
#include <string_view>

#include "protocol/wire/json.h"
#include "tests/soak/framing.h"
#include "tests/soak/pending_answers.h"
#include "tests/soak/subscriptions.h"

namespace hedgehog::soak {

struct Endpoints {
  int port = 0;
  int http_port = 0;
  std::string socket;
};

class Peer;

/// What is done with messages, once they are known to be right.
class PeerObserver {
 public:
  virtual ~PeerObserver() = default;
  virtual void on_answer(Peer& peer, const AnsweredRequest& answered) = 0;
  virtual void on_notification(Peer& peer, const protocol::Json& message) = 0;
};

class Peer {
 public:
  /// Connects. `receive_buffer`: bytes that wait in the system, 0: its default.
  Peer(Transport transport, const Endpoints& endpoints, int receive_buffer);
  Peer(const Peer&) = delete;
  Peer& operator=(const Peer&) = delete;
  ~Peer() { close(); }

  /// One message, expecting what it deserves. `fragments`: of its WebSocket frame.
  void send(const std::string& message, int fragments = 1);
  /// The first part of a line; the rest goes before whatever is sent next.
  void send_in_parts(const std::string& line, std::size_t first);
  /// A message of more than 64 KiB.
  void send_too_long(std::size_t bytes);
  /// As they are; nothing is expected.
  void send_bytes(std::string_view bytes);
  /// The rest of a line that was sent in part.
  void complete_line();

  /// Sends no more. The responses are still to come.
  void half_close();
  void close();
  /// So that the daemon's system reports a reset.
  void reset();

  /// The daemon may close from now on, and `why`.
  void provoke(std::string why) { provoked_ = std::move(why); }
  const std::string& provoked() const noexcept { return provoked_; }

  /// Reads and writes what it can.
  void exchange(bool readable, bool writable, PeerObserver& observer);
  bool wants_to_write() const noexcept {
    return is_open() && !(is_upgrading() ? handshake_ : out_).empty();
  }
  bool wants_to_read() const noexcept { return is_open() && reads_; }
  void read(bool on) noexcept { reads_ = on; }
  bool reads() const noexcept { return reads_; }

  int fd() const noexcept { return fd_; }
  bool is_open() const noexcept { return fd_ >= 0; }
  /// The daemon has closed, or reset, the connection.
  bool is_closed_by_daemon() const noexcept { return closed_by_daemon_; }
  bool is_half_closed() const noexcept { return half_closed_; }
  bool is_partial() const noexcept { return !rest_.empty(); }
  Transport transport() const noexcept { return transport_; }
  std::size_t pending() const noexcept { return answers_.size(); }
  std::size_t unsent_bytes() const noexcept { return out_.size(); }
  bool has_received() const noexcept { return received_; }
  /// The daemon's number of this connection, once it is known.
  std::optional<std::int64_t> number() const noexcept { return number_; }
  /// As the daemon's log names it; empty for a Unix socket.
  const std::string& address() const noexcept { return address_; }
  /// For a report: what was sent last, and what is missing.
  std::string text() const;

 private:
  /// A WebSocket's frames wait for the response to its handshake (RFC 6455, section 4.1).
  bool is_upgrading() const noexcept {
    return transport_ == Transport::kWebSocket && unframer_.status() == 0;
  }
  void connect(const Endpoints& endpoints, int receive_buffer);
  void record(const std::string& sent);
  void receive(const Received& message, PeerObserver& observer);
  void read_some(PeerObserver& observer);
  void write_some();
  void shut_when_sent();

  Transport transport_;
  int fd_ = -1;
  std::string address_;
  Unframer unframer_;
  std::string handshake_;
  std::string out_;
  std::string rest_;  // of a line that was sent in part, without its LF
  std::string part_;  // of the same line
  PendingAnswers answers_;
  Subscriptions subscriptions_;
  std::optional<std::int64_t> number_;
  std::string provoked_;
  std::deque<std::string> transcript_;
  bool reads_ = true;
  bool received_ = false;
  bool half_closed_ = false;
  bool shut_ = false;  // the system knows of the half close
  bool closed_by_daemon_ = false;
};

}  // namespace hedgehog::soak
