// SPDX-License-Identifier: MIT
// A connection to the daemon: blocking calls with deadlines, and a queue of notifications.
//
//   auto ball = Connection::open(daemon_addresses().value()).value();
//   EffectParams push{.direction = Word::kLeft, .level = 0.6, .duration_ms = 180};
//   auto felt = ball.call(EffectStart{model::EffectMethod::kPulse, push});
//   if (!felt) puts(felt.error().message.c_str());
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "clients/lib/address.h"
#include "clients/lib/backoff.h"
#include "clients/lib/client_error.h"
#include "clients/lib/line_socket.h"
#include "clients/lib/response_timeout.h"
#include "protocol/client_codec.h"

namespace hedgehog::client {

using Notification = std::variant<protocol::EventMessage, protocol::TelemetryMessage>;

/// One thread at a time. Movable. The destructor ends the connection, and with it its effects.
class Connection {
 public:
  static constexpr Milliseconds kConnectTimeout{2000};
  /// Limit of unread telemetry, beyond which the oldest is dropped; events are never dropped.
  static constexpr std::size_t kMaxTelemetry = 256;

  /// Connects to the first of `addresses` that accepts, and sends the token of that address in a
  /// hello. mdns:// addresses are searched for first, for `kSearchTime` more. kNoDaemon: "no daemon
  /// answers at A or B". kRefused: the token is unknown.
  static Outcome<Connection> open(const std::vector<Address>& addresses,
                                  Milliseconds timeout = kConnectTimeout);
  /// The same repeatedly, with the pauses of `Backoff` or longer ones (`retry_after`), until
  /// `timeout` has elapsed or a later attempt cannot succeed (`may_connect_later`): each attempt
  /// with a wrong token makes the daemon wait longer before it checks the next.
  static Outcome<Connection> reopen(const std::vector<Address>& addresses, Milliseconds timeout);

  /// REQUIRES: `address` is not an mdns:// address (see `locate`).
  /// Begins to connect and does not block (`LineSocket::start_connect`); no other call is allowed
  /// before `connected` returns true.
  static Outcome<Connection> start(const Address& address);
  /// After `start`: whether it is connected, by `deadline` at the latest. kNoDaemon: no listener;
  /// the message is the reason alone.
  Outcome<bool> connected(Clock::time_point deadline) { return socket_.connected(deadline); }

  /// Sends one of the requests of protocol/methods.h and blocks until its response, for `timeout`
  /// at most.
  template <class Request>
  Outcome<typename Request::Result> call(const Request& request,
                                         Milliseconds timeout = response_timeout()) {
    return decoded<typename Request::Result>(call_text(request, timeout));
  }
  /// The same, with the result as the JSON text that the daemon sent.
  Outcome<std::string> call_text(const protocol::Request& request,
                                 Milliseconds timeout = response_timeout());
  /// The same for any method; `params_json` is an object or empty.
  Outcome<std::string> call_raw(std::string_view method, std::string_view params_json,
                                Milliseconds timeout = response_timeout());

  /// Sends a notification: a request without a response.
  Outcome<void> notify(const protocol::Request& request, Milliseconds timeout = response_timeout());
  /// The same for any method; `params_json` is an object or empty.
  Outcome<void> notify_raw(std::string_view method, std::string_view params_json,
                           Milliseconds timeout = response_timeout());

  /// Sends a request and does not wait for its response: `response` returns it once `next` or a
  /// call has read it.
  Outcome<protocol::Id> request(const protocol::Request& request,
                                Milliseconds timeout = response_timeout());
  /// The same for any method; `params_json` is an object or empty.
  Outcome<protocol::Id> request_raw(std::string_view method, std::string_view params_json,
                                    Milliseconds timeout = response_timeout());
  /// The oldest unread response to a `request`; does not read the socket.
  std::optional<protocol::Reply> response();

  /// Sends the name of the client program ("Racer/1.2"). Optional.
  Outcome<protocol::HelloResult> hello(std::string client, std::optional<std::string> token = {},
                                       Milliseconds timeout = response_timeout());

  /// The oldest unread event or telemetry; nullopt when none was received within `timeout` (0:
  /// only what is already in the buffers).
  Outcome<std::optional<Notification>> next(Milliseconds timeout);
  /// Reads one line of any kind for `notification` and `response`; false when none was received
  /// within `timeout`. kRefused: an error about the connection, which stays open.
  Outcome<bool> receive(Milliseconds timeout);
  /// The oldest unread event or telemetry; does not read the socket.
  std::optional<Notification> notification();

  /// For poll(2) in a loop that also waits for other sources: when it is readable, call `next` with
  /// timeout 0 until it returns nothing. -1 once the connection is closed.
  int descriptor() const noexcept { return socket_.descriptor(); }
  const Address& address() const noexcept { return address_; }

 private:
  Connection(LineSocket socket, Address address);
  /// `connection`, once the daemon has accepted the token of its address.
  static Outcome<Connection> after_hello(Connection connection, Clock::time_point deadline);

  template <class T>
  static Outcome<T> decoded(const Outcome<std::string>& json) {
    if (!json) return json.error();
    auto value = protocol::decode_result<T>(*json);
    if (!value) return ClientError{Failure::kProtocol, value.error().message, {}};
    return *std::move(value);
  }
  Outcome<std::string> exchange(const protocol::Id& id, const std::string& line,
                                Milliseconds timeout);
  /// Queues the messages of a line; returns the response to `id` if it is among them.
  Outcome<std::optional<protocol::Reply>> handle_line(const std::string& line,
                                                      const protocol::Id& id);
  void queue(Notification notification);
  Outcome<protocol::Id> send_request(const protocol::Id& id, const std::string& line,
                                     Milliseconds timeout);

  LineSocket socket_;
  Address address_;
  std::int64_t last_id_ = 0;
  std::deque<protocol::Id> pending_;  // without a response so far
  std::deque<protocol::Reply> responses_;
  std::deque<Notification> unread_;
  std::size_t unread_telemetry_ = 0;
};

}  // namespace hedgehog::client
