// SPDX-License-Identifier: MIT
// The client interface for a game: connects and reconnects automatically; calls of a frame loop do
// not block. The effects of a connection end with it.
//
//   Ball ball(client::daemon_addresses().value());
//   for (;;) {  // each frame
//     ball.update();
//     ball.rumble("engine", throttle, protocol::Word::kBack, {.frequency_hz = 70});
//   }
#pragma once

#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "clients/lib/connection.h"
#include "clients/lib/discovery/ball_search.h"
#include "clients/lib/subscriptions.h"

namespace hedgehog {

struct BallOptions {
  /// Name of this program in the daemon's log.
  std::string name = "c++";
  /// For roles beyond the default of this machine; nullopt: that of the address (HEDGEHOG_TOKEN).
  std::optional<std::string> token{};
  /// Timeout of connecting and of a response.
  client::Milliseconds timeout = client::response_timeout();
};

/// `strength` 0..1 of a game as a level: 0 stays 0 (and NaN is 0); values above 0 start at the
/// perception threshold.
double felt_level(double strength, const protocol::HelloLimits& limits) noexcept;

/// One thread at a time; starts none. Only `connect`, `open`, `call`, `call_raw` and the effects
/// that return an admission block, for `timeout` at most; everything else returns at once (except
/// the look-up of a host name, which may take longer: games should use numeric addresses or
/// mdns://NAME).
///
/// Errors: kRefused contains the daemon's RpcError. kNoDaemon: "the daemon does not run: ...".
/// kClosed, kTimeout and kProtocol end the connection; the next call reconnects, no earlier than
/// `retry_after` allows. Subscriptions are renewed on the new connection, and `refused_renewal`
/// returns those that were rejected; effects are not started again: a change of `connections`
/// indicates a new connection.
class Ball {
 public:
  /// Lease of a rumble since its last frame: a game that hangs releases the ball.
  static constexpr std::int64_t kRumbleLeaseMs = 250;
  /// Limit of unread notifications; the oldest are dropped.
  static constexpr std::size_t kMaxUnread = 10'000;
  /// Limit of unread refused renewals; the oldest are dropped.
  static constexpr std::size_t kMaxRefused = 16;

  /// Does not connect yet; the first `update` does.
  explicit Ball(std::vector<client::Address> addresses, BallOptions options = {});
  /// A connected ball at the default addresses of all clients (`daemon_addresses`). Blocking.
  static client::Outcome<Ball> connect(BallOptions options = {});

  /// Once a frame: connects, reads what was received, ends a connection whose response is overdue.
  void update();
  bool connected() const noexcept { return stage_ == Stage::kConnected; }
  /// Connections made so far.
  int connections() const noexcept { return connections_; }
  /// Why it is not connected, one sentence; empty: it is connected, or the first attempt is in
  /// progress.
  std::string problem() const { return failure_ ? failure_->message : std::string(); }
  /// The same as an error. REQUIRES: not connected, and at least one attempt has ended.
  const client::ClientError& failure() const { return *failure_; }
  /// Time until the next attempt to connect; 0: the next call makes one.
  client::Milliseconds retry_after() const;
  /// Address of the connection. REQUIRES: connected.
  const client::Address& address() const noexcept { return connection_->address(); }
  /// For poll(2) in a loop that also waits for other sources; when it is readable, call `update`.
  /// -1: no connection, or still connecting. An update leaves lines beyond the first 100 for the
  /// next one, without the socket being readable again: wait with a timeout.
  int descriptor() const noexcept {
    return stage_ > Stage::kConnecting ? connection_->descriptor() : -1;
  }
  /// Limits and role, of the last connection. REQUIRES: it was connected once.
  const protocol::HelloResult& hello() const noexcept { return hello_; }

  /// A vibration that lasts while this is called every frame: strength 0..1, 0 ends it. False:
  /// nothing was sent because there is no connection; `update` reconnects.
  bool rumble(std::string_view slot, double strength,
              std::optional<protocol::Direction> direction = std::nullopt,
              protocol::EffectParams others = {});
  /// Sends a notification, which has no response. False: nothing was sent.
  bool notify(const protocol::Request& request);
  /// The same for any method; `params_json` is an object or empty. A subscription is renewed on the
  /// next connection only if this library supports its parameters; with `request_raw`, if the
  /// daemon accepts it.
  bool notify_raw(std::string_view method, std::string_view params_json);
  /// Sends a request; `response` returns the response some frames later. nullopt: nothing was sent.
  std::optional<protocol::Id> request(const protocol::Request& request);
  std::optional<protocol::Id> request_raw(std::string_view method, std::string_view params_json);
  /// The oldest response to a `request`.
  std::optional<protocol::Reply> response();
  /// The oldest subscription that the daemon refused to renew on a new connection (another version,
  /// another role): kRefused, "events.subscribe: ...". The subscription has ended. At most one of
  /// each kind per connection is kept, `kMaxRefused` in all.
  std::optional<client::ClientError> refused_renewal();
  /// The oldest unread event or telemetry.
  std::optional<client::Notification> next();

  /// Connects unless it is connected. Blocking.
  client::Outcome<void> open();
  /// Blocks until the response.
  template <class Request>
  client::Outcome<typename Request::Result> call(const Request& request) {
    const auto json = exchange(protocol::Request(request));
    if (!json) return json.error();
    auto value = protocol::decode_result<typename Request::Result>(*json);
    if (!value) return client::ClientError{client::Failure::kProtocol, value.error().message, {}};
    return *std::move(value);
  }
  /// The same for any method; the result is the JSON text that the daemon sent.
  client::Outcome<std::string> call_raw(std::string_view method, std::string_view params_json);
  /// Reads until a notification is received, `timeout` at most; returns as `next`.
  client::Outcome<std::optional<client::Notification>> next(client::Milliseconds timeout);

  /// Effects, with the daemon's admission. Blocking.
  using Admitted = client::Outcome<protocol::Admission>;
  Admitted pulse(protocol::Direction direction, protocol::EffectParams others = {});
  Admitted vibrate(protocol::Direction direction, protocol::EffectParams others = {});
  Admitted hold(protocol::Direction direction, protocol::EffectParams others = {});
  Admitted circle(protocol::Direction axis, protocol::EffectParams others = {});
  Admitted play(std::string pattern, protocol::EffectParams others = {});

 private:
  enum class Stage : std::uint8_t { kDisconnected, kSearching, kConnecting, kHello, kConnected };
  struct PendingRequest {
    protocol::Id id;
    client::Clock::time_point deadline;
  };
  static constexpr client::Milliseconds kNow{0};

  void start_attempt();
  /// Blocks until `deadline` at most.
  void poll_search(client::Clock::time_point deadline);
  void start_next_address();
  /// Blocks until `deadline` at most.
  void poll_connection(client::Clock::time_point deadline);
  void send_hello();
  /// Queues the messages of one line; false: none was received within `timeout`, or the connection
  /// has ended.
  bool receive(client::Milliseconds timeout);
  void handle_reply(protocol::Reply reply);
  void expire();
  void renew_subscriptions();
  void record_refused_renewal(const std::string& method, const protocol::RpcError& refusal);
  client::Outcome<protocol::Id> send(const client::AnyRequest& request);
  std::optional<protocol::Id> request_any(const client::AnyRequest& request);
  bool notify_any(const client::AnyRequest& request);
  /// The response; blocks until its deadline at most.
  client::Outcome<std::string> exchange(const client::AnyRequest& request);
  std::optional<protocol::Reply> take_response(const protocol::Id& id);
  /// False: `sent` failed; ends the connection unless the request itself was at fault.
  bool check_sent(const client::Outcome<void>& sent);
  client::ClientError end_connection(const client::ClientError& why);
  /// `min_wait`: lower bound of the time until the next attempt.
  client::ClientError fail_attempt(client::Failure failure, std::string problem,
                                   client::Milliseconds min_wait = kNow);

  std::vector<client::Address> addresses_;
  BallOptions options_;
  Stage stage_ = Stage::kDisconnected;
  std::optional<client::Connection> connection_;
  std::optional<client::BallSearch> search_;
  std::vector<client::Address> located_;  // of this attempt
  std::size_t next_address_ = 0;
  client::Clock::time_point due_{};  // deadline of the attempt to connect
  std::string attempt_errors_;       // addresses, and why each failed
  std::optional<protocol::Id> hello_id_;
  int connections_ = 0;
  client::Subscriptions subscriptions_;
  std::vector<protocol::Id> renewals_;  // whose responses are discarded
  std::deque<client::ClientError> refused_renewals_;
  std::deque<PendingRequest> pending_;
  std::deque<protocol::Reply> responses_;
  std::deque<client::Notification> notifications_;
  protocol::HelloResult hello_{};
  client::Backoff backoff_;
  client::Clock::time_point next_attempt_{};
  std::optional<client::ClientError> notice_;   // that the daemon sent about this connection
  std::optional<client::ClientError> failure_;  // why the last connection ended
};

}  // namespace hedgehog
