// SPDX-License-Identifier: MIT
// The ball for a game's frame loop: nothing waits, and a daemon that was lost is found again.
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
  /// Of this program, as the daemon's log and `hedgehogctl clients` show it.
  std::string name = "unreal";
  /// Connecting, and waiting for a response, take no longer.
  double patience_s = 2.0;
  /// Of roles beyond those of this machine.
  std::string token{};
};

struct Listeners {
  /// What the daemon tells of itself: server, role, limits.
  std::function<void(const Json& hello)> connected{};
  /// Why there is no daemon any more; also once an outage that was there from the beginning.
  std::function<void(const std::string& reason)> disconnected{};
  std::function<void(const std::string& method, const Json& params)> notification{};
  /// The daemon of a new connection refuses a subscription ("events.subscribe"), which has ended.
  std::function<void(const std::string& method, const Answer& refusal)> subscription_ended{};
};

/// One thread. Listeners are called from `poll` and `close` alone. When it goes away the connection
/// ends, and with it its effects.
class Client {
 public:
  static constexpr double kFirstWaitS = 0.1;
  static constexpr double kMaxWaitS = 5.0;
  /// A rumble ends so long after its last frame: a game that hangs lets go of the ball.
  static constexpr int kLeaseMs = 250;

  Client(Settings settings, Connect connect, Listeners listeners);

  /// Once a frame. `now_s`: seconds of any clock that does not go back.
  void poll(double now_s);
  /// Ends the connection; nothing connects again.
  void close();

  /// Waits for the connection where there is none yet. Parameters that are null are left out. What
  /// a method ending in ".subscribe" asks for is asked for again on every new connection, until its
  /// ".unsubscribe" or until the daemon refuses it.
  void request(const std::string& method, const Json& params, OnAnswer on_answer);
  /// For every frame: expects no response. false: nothing was sent, there is no daemon.
  bool notify(const std::string& method, const Json& params);
  /// A vibration that goes on while this is called every frame; strength 0..1, 0 ends it. `params`:
  /// the rest of the effect, and another lease.
  bool rumble(const std::string& slot, double strength, const Json& direction,
              const Json& params = Json::object());

  bool is_open() const { return session_ != nullptr && session_->is_open() && greeted_; }
  /// Null: not connected.
  const Json& hello() const;

 private:
  struct Waiting {
    std::string method;
    Json params;
    OnAnswer on_answer;
    std::int64_t change;  // of the subscriptions; 0: none
  };
  void ask(Waiting one);
  void renew(const Subscriptions::Change& one);
  void connect();
  void begin();
  void lose();
  void end(const std::string& reason, const Json& refusal);
  void fail_all(std::vector<OnAnswer> unanswered, const Answer& answer);
  void fail_later(OnAnswer on_answer, Answer answer);
  void report_later();
  void back_off();
  double remaining_s() const;

  Settings settings_;
  Connect connect_;
  Listeners listeners_;
  /// Shared with a `poll` under way, in which a listener may close it.
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

/// `strength` 0..1 as a level: 0 stays 0; anything above begins where a push can be felt. `limits`:
/// of hello.
double felt_level(double strength, const Json& limits);

}  // namespace hedgehog::unreal
