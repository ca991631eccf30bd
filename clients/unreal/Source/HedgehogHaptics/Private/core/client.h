// SPDX-License-Identifier: MIT
// The client for a game's frame loop: no call blocks, and lost connections are re-established.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/address.h"
#include "core/answer.h"
#include "core/session.h"
#include "core/subscriptions.h"
#include "core/transport.h"

namespace hedgehog::unreal {

struct Settings {
  /// "127.0.0.1:7586"; empty: see `find_daemon`.
  std::string address{};
  /// Name of this program in the daemon's log and in `hedgehogctl clients`.
  std::string name = "unreal";
  /// Timeout of connecting and of a response.
  double timeout_s = 2.0;
  /// For roles beyond the default of this machine; empty: HEDGEHOG_TOKEN.
  std::string token{};
};

struct Listeners {
  /// The daemon's hello: server, role, limits.
  std::function<void(const Json& hello)> connected{};
  /// Why the connection was lost; also once if the first attempt fails.
  std::function<void(const std::string& reason)> disconnected{};
  std::function<void(const std::string& method, const Json& params)> notification{};
  /// The daemon of a new connection refused to renew a subscription ("events.subscribe"), which has
  /// ended.
  std::function<void(const std::string& method, const Answer& refusal)> subscription_ended{};
};

/// One thread. Listeners are called only from `poll` and `close`. The destructor ends the
/// connection, and with it its effects.
class Client {
 public:
  static constexpr double kFirstWaitS = 0.1;
  static constexpr double kMaxWaitS = 5.0;
  /// Lease of a rumble since its last frame: a game that hangs releases the ball.
  static constexpr int kLeaseMs = 250;

  Client(Settings settings, Connect connect, Listeners listeners);

  /// Once a frame. `now_s`: seconds of any monotonic clock.
  void poll(double now_s);
  /// Ends the connection permanently.
  void close();

  /// Queued until the connection is established. Null parameters are omitted. A request of a method
  /// ending in ".subscribe" is repeated on every new connection, until its ".unsubscribe" or until
  /// the daemon refuses it.
  void request(const std::string& method, const Json& params, OnAnswer on_answer);
  /// For every frame: without a response. False: nothing was sent because there is no connection.
  bool notify(const std::string& method, const Json& params);
  /// A vibration that lasts while this is called every frame; strength 0..1, 0 ends it. `params`:
  /// further parameters of the effect, or another lease.
  bool rumble(const std::string& slot, double strength, const Json& direction,
              const Json& params = Json::object());

  bool is_open() const { return session_ != nullptr && session_->is_open() && greeted_; }
  /// Null if not connected.
  const Json& hello() const;

 private:
  struct Waiting {
    std::string method;
    Json params;
    OnAnswer on_answer;
    std::int64_t change;  // order in the subscriptions; 0: none
  };
  void ask(Waiting one);
  void renew(const Subscriptions::Change& one);
  std::string shown_token() const;
  void connect();
  void begin();
  void lose();
  void end(const std::string& reason, const Json& refusal);
  void fail_all(std::vector<OnAnswer> unanswered, const Answer& answer);
  void fail_later(OnAnswer on_answer, Answer answer);
  void report_later();
  /// `min_s`: lower bound of the wait.
  void back_off(double min_s = 0.0);
  double remaining_s() const;

  Settings settings_;
  Connect connect_;
  Listeners listeners_;
  /// Shared with a `poll` in progress, in which a listener may close it.
  std::shared_ptr<Session> session_;
  Address place_;
  bool greeted_ = false;
  bool closed_ = false;
  bool reported_ = false;
  double now_s_ = 0.0;
  double wait_s_ = 0.0;
  double next_attempt_s_ = 0.0;
  std::vector<Waiting> queue_;
  std::vector<std::pair<OnAnswer, Answer>> later_;
  Subscriptions subscriptions_;
};

/// `strength` 0..1 as a level: 0 stays 0; values above 0 start at the perception threshold.
/// `limits`: of hello.
double felt_level(double strength, const Json& limits);

}  // namespace hedgehog::unreal
