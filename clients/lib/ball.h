// SPDX-License-Identifier: MIT
// The ball for a game: connects by itself and again, and in a frame loop nothing waits. The effects
// of a connection end with it.
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
  /// Of this program, as the daemon's log shows it.
  std::string name = "c++";
  /// Of roles beyond those of this machine; else that of the address (HEDGEHOG_TOKEN).
  std::optional<std::string> token{};
  /// The longest that connecting, and waiting for a response, take.
  client::Milliseconds patience = client::response_timeout();
};

/// `strength` 0..1 of a game as a level: 0 stays 0 (and NaN is 0), anything above begins where a
/// push can be felt.
double felt_level(double strength, const protocol::HelloLimits& limits) noexcept;

/// One thread at a time; starts none. Only `connect`, `open`, `call`, `call_raw` and the effects
/// that return an admission wait, `patience` at most; everything else returns at once (a host's
/// name is looked up, which may take longer: a game gives numbers, or mdns://NAME).
///
/// Errors: kRefused has the daemon's RpcError. kNoDaemon: "the daemon does not run: ...". kClosed,
/// kTimeout and kProtocol end the connection; the next call connects anew, no more often than
/// `retry_after` allows. What the program subscribed to is subscribed to again, and
/// `refused_renewal` has what could not be; its effects are not made again: `connections` shows
/// that there is a new connection.
class Ball {
 public:
  /// A rumble ends so long after its last frame: a game that hangs lets go of the ball.
  static constexpr std::int64_t kRumbleLeaseMs = 250;
  /// Notifications that nobody has fetched; the oldest are dropped.
  static constexpr std::size_t kMaxWaiting = 10'000;
  /// Refused renewals that nobody has fetched; the oldest are dropped.
  static constexpr std::size_t kMaxRefused = 16;

  /// Does not connect yet: `update` begins.
  explicit Ball(std::vector<client::Address> addresses, BallOptions options = {});
  /// A ball that is connected, found as every client finds the daemon. Waits.
  static client::Outcome<Ball> connect(BallOptions options = {});

  /// Once a frame: connects, reads what has come, ends a connection whose response is overdue.
  void update();
  bool connected() const noexcept { return stage_ == Stage::kConnected; }
  /// Connections made so far.
  int connections() const noexcept { return connections_; }
  /// Why it is not connected, one sentence; empty: it is, or the first attempt is under way.
  std::string problem() const { return failure_ ? failure_->message : std::string(); }
  /// The same as an error. REQUIRES: it is not connected, and was once or tried to.
  const client::ClientError& failure() const { return *failure_; }
  /// How long no other attempt to connect is made; 0: the next call makes one.
  client::Milliseconds retry_after() const;
  /// REQUIRES: it was connected once. Of the last connection: limits and role.
  const protocol::HelloResult& hello() const noexcept { return hello_; }

  /// A vibration that goes on while this is called every frame: strength 0..1, 0 ends it. False:
  /// nothing was sent, there is no daemon; `update` connects meanwhile.
  bool rumble(std::string_view slot, double strength,
              std::optional<protocol::Direction> direction = std::nullopt,
              protocol::EffectParams others = {});
  /// Sends and wants no response. False: nothing was sent.
  bool notify(const protocol::Request& request);
  /// The same for any method; `params_json` is an object or empty. A subscription is made again on
  /// the next connection only if this library knows its parameters; with `ask_raw`, if the daemon
  /// accepts it.
  bool notify_raw(std::string_view method, std::string_view params_json);
  /// Sends; `answer` has the response a few frames later. nullopt: nothing was sent.
  std::optional<protocol::Id> ask(const protocol::Request& request);
  std::optional<protocol::Id> ask_raw(std::string_view method, std::string_view params_json);
  /// The oldest response to an `ask`.
  std::optional<protocol::Reply> answer();
  /// The oldest subscription that the program had and a new connection could not make again, as the
  /// daemon refused it (another version, another role): kRefused, "events.subscribe: ...". It has
  /// ended. At most one of each kind for a connection is kept, `kMaxRefused` in all.
  std::optional<client::ClientError> refused_renewal();
  /// The oldest event or telemetry that was read and not yet taken.
  std::optional<client::Notification> next();

  /// Connects unless it is connected. Waits.
  client::Outcome<void> open();
  /// Waits for the response.
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
  /// Reads until something has come, `patience` at most, and as `next`.
  client::Outcome<std::optional<client::Notification>> next(client::Milliseconds patience);

  /// Effects, with what the daemon makes of them. Wait.
  using Admitted = client::Outcome<protocol::Admission>;
  Admitted pulse(protocol::Direction direction, protocol::EffectParams others = {});
  Admitted vibrate(protocol::Direction direction, protocol::EffectParams others = {});
  Admitted hold(protocol::Direction direction, protocol::EffectParams others = {});
  Admitted circle(protocol::Direction axis, protocol::EffectParams others = {});
  Admitted play(std::string pattern, protocol::EffectParams others = {});

 private:
  enum class Stage : std::uint8_t { kAway, kSearching, kConnecting, kIntroducing, kConnected };
  struct Asked {
    protocol::Id id;
    client::Clock::time_point deadline;
  };
  static constexpr client::Milliseconds kNow{0};

  void start_attempt();
  /// Waits until `deadline` at most.
  void poll_search(client::Clock::time_point deadline);
  void start_next_address();
  /// Waits until `deadline` at most.
  void poll_connection(client::Clock::time_point deadline);
  void introduce();
  /// Keeps what one line has; false: none came within `patience`, or the connection has ended.
  bool receive(client::Milliseconds patience);
  void take(protocol::Reply reply);
  void expire();
  void renew_subscriptions();
  void keep_refusal(const std::string& method, const protocol::RpcError& refusal);
  client::Outcome<protocol::Id> send(const client::AnyRequest& request);
  std::optional<protocol::Id> ask_any(const client::AnyRequest& request);
  bool notify_any(const client::AnyRequest& request);
  /// The response, by when it is due.
  client::Outcome<std::string> exchange(const client::AnyRequest& request);
  std::optional<protocol::Reply> take_answer(const protocol::Id& id);
  /// False: `sent` failed; a connection that is of no further use has ended.
  bool keep(const client::Outcome<void>& sent);
  client::ClientError lose(const client::ClientError& why);
  client::ClientError stay_away(client::Failure failure, std::string problem);

  std::vector<client::Address> addresses_;
  BallOptions options_;
  Stage stage_ = Stage::kAway;
  std::optional<client::Connection> connection_;
  std::optional<client::BallSearch> search_;
  std::vector<client::Address> located_;  // of this attempt
  std::size_t next_address_ = 0;
  client::Clock::time_point due_{};  // of the attempt to connect
  std::string tried_;                // addresses, and why each did not answer
  std::optional<protocol::Id> introduction_;
  int connections_ = 0;
  client::Subscriptions subscriptions_;
  std::vector<protocol::Id> renewals_;  // whose responses nobody waits for
  std::deque<client::ClientError> refused_renewals_;
  std::deque<Asked> asked_;
  std::deque<protocol::Reply> answers_;
  std::deque<client::Notification> notifications_;
  protocol::HelloResult hello_{};
  client::Backoff backoff_;
  client::Clock::time_point next_attempt_{};
  std::string notice_;                          // by the daemon, of this connection
  std::optional<client::ClientError> failure_;  // why the last connection ended
};

}  // namespace hedgehog
